#pragma once

#include <filesystem>

namespace corpuscle {

/// Writes `view.py` into a folder of families (.hdf.series): one file for ParaView (File > Load State, or paraview --script=view.py) that
/// opens all of them, coloured and animated. Throws Error.
void write_view_script(const std::filesystem::path& folder);

}  // namespace corpuscle
