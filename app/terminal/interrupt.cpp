#include "app/terminal/interrupt.hpp"

#include <csignal>

namespace corpuscle {

namespace {

// The one thing a signal handler can reach.
std::atomic<bool> stop_requested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void request_stop(int)
{
    stop_requested = true;
}

void handle(int signal, void (*handler)(int))
{
    struct sigaction action{};
    action.sa_handler = handler;
    action.sa_flags = handler == SIG_DFL ? 0 : static_cast<int>(SA_RESETHAND);
    sigaction(signal, &action, nullptr);
}

}  // namespace

InterruptWatch::InterruptWatch()
{
    handle(SIGINT, request_stop);
    handle(SIGTERM, request_stop);
}

InterruptWatch::~InterruptWatch()
{
    handle(SIGINT, SIG_DFL);
    handle(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& InterruptWatch::requested() const
{
    return stop_requested;
}

}  // namespace corpuscle
