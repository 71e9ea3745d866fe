#include "app/terminal/child.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "base/error.hpp"

namespace corpuscle {

Child::Child(const std::vector<std::string>& words)
{
    std::vector<std::string> own = words;
    std::vector<char*> arguments;
    for (std::string& word : own) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    const int problem = posix_spawn(&process_, own.front().c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (problem != 0) throw Error(fmt::format("cannot start '{}': {}", own.front(), std::strerror(problem)), "is there enough memory?");
}

std::optional<int> Child::ended()
{
    int status = 0;
    if (!code_ && waitpid(process_, &status, WNOHANG) == process_) code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return code_;
}

void Child::ask_to_stop() const
{
    if (!code_) kill(process_, SIGTERM);
}

}  // namespace corpuscle
