#pragma once

namespace corpuscle {

/// Lets threads that wait for others at the end of a loop give up their core after some ten microseconds, unless the environment
/// says how they should wait. The OpenMP runtime reads this when the program is loaded, so the program starts itself anew, once.
void settle_waiting(char** argv);

}  // namespace corpuscle
