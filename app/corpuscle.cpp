#include "app/command_line.hpp"
#include "app/waiting.hpp"

int main(int argc, char** argv)
{
    corpuscle::settle_waiting(argv);
    return corpuscle::run_command_line(argc, argv);
}
