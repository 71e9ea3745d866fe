#pragma once

namespace corpuscle {

/// Exit codes of the program.
enum ExitCode : int { exit_done = 0, exit_wrong_input = 2, exit_safety_stop = 3, exit_interrupted = 130 };

/// Does what the command line says; returns the exit code. Every error is told on standard error, flushed.
int run_command_line(int argc, char** argv);

}  // namespace corpuscle
