#include "app/options.hpp"

namespace corpuscle {

std::vector<std::filesystem::path> Options::installed_share() const
{
    return {program.parent_path().parent_path() / "share" / "corpuscle", CORPUSCLE_SOURCE_SHARE};
}

}  // namespace corpuscle
