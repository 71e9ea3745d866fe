#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>

#include "output/replace_file.hpp"
#include "output/vtk/cells.hpp"
#include "output/vtk/image.hpp"
#include "output/vtk/points.hpp"
#include "output/vtk/series.hpp"
#include "output/vtk/view_script.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

/// What a shell command answers: its exit code and, in `text`, what it printed.
int shell(const std::string& command, const std::filesystem::path& printed, std::string& text)
{
    const int status = std::system(("(" + command + ") > '" + printed.string() + "' 2>&1").c_str());
    text = read_file(printed);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// A gas that moves: two dumps of more particles than a chunk holds, and one of none.
void write_gas(const std::filesystem::path& folder, int gzip)
{
    constexpr std::size_t count = 150'000;
    VtkSeries series(folder, gzip > 0 ? "gas_small" : "gas");
    for (int dump = 0; dump < 2; ++dump) {
        std::vector<Vector3f> position(count);
        for (std::size_t i = 0; i < count; ++i) {
            const float part = static_cast<float>(i) / static_cast<float>(count - 1);
            position[i] = {part, 2 * part, static_cast<float>(dump) + part};
        }
        FieldSet fields{"gas", {stored_field("position", "m", "", position)}};
        fields.fields.push_back(
            derived_field<float>("speed", "m/s", "", count, [](std::size_t i) { return static_cast<float>(i % 1000); }));
        fields.fields.push_back(
            derived_field<std::uint8_t>("species", "1", "", count, [](std::size_t i) { return static_cast<std::uint8_t>(i % 3); }));
        fields.fields.push_back(derived_field<std::uint64_t>("identity", "1", "", count, [](std::size_t i) { return std::uint64_t{i}; }));
        series.add(1e-4 * dump, [&](const auto& path) { write_points(path, fields.fields[0], fields, {gzip}); });
    }
    std::vector<Vector3f> none;
    VtkSeries empty(folder, "empty");
    empty.add(0, [&](const auto& path) { write_points(path, stored_field("position", "m", "", none), {}); });
}

/// A mesh of one element of each shape.
void write_mesh(const std::filesystem::path& folder)
{
    std::vector<Vector3d> nodes{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const std::vector<MeshElement> elements{{ElementShape::quadrilateral, {0, 1, 2, 3}},
                                            {ElementShape::triangle, {4, 5, 6}},
                                            {ElementShape::tetrahedron, {0, 1, 2, 4}},
                                            {ElementShape::hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}}};
    std::vector<Vector3d> velocity(8, {1, -2, 3});
    std::vector<double> stress{1e6, 2e6, 3e6, 4e6};
    std::vector<std::uint32_t> part{0, 0, 1, 7};
    const GridFields fields{{"nodes", {stored_field("velocity", "m/s", "", velocity)}},
                            {"elements", {stored_field("von_mises", "Pa", "", stress), stored_field("part", "1", "", part)}}};
    VtkSeries series(folder, "structure");
    for (const double time : {0.0, 0.5, 2.5}) {
        series.add(time,
                   [&](const auto& path) { write_cells(path, stored_field("position", "m", "", nodes), cell_grid(elements), fields); });
    }
}

/// Averages on a regular grid.
void write_averages(const std::filesystem::path& folder)
{
    const ImageGrid grid = cell_centers({4, 3, 2}, {-1, 0, 1}, {0.5, 0.25, 2});
    const auto x_index = derived_field<float>("x_index", "1", "", 24, [](std::size_t i) { return static_cast<float>(i % 4); });
    const auto flow =
        derived_field<Vector3f>("velocity", "m/s", "", 24, [](std::size_t i) { return Vector3f(1, 2, static_cast<float>(i / 12)); });
    VtkSeries series(folder, "cells");
    series.add(0.125, [&](const auto& path) { write_image(path, grid, {"cells", {x_index, flow}}, {1}); });
}

TEST(ParaView, OpensEveryFamily)
{
    const ScratchFolder folder;
    std::string text;
    if (shell("command -v pvpython", folder / "printed", text) != 0) GTEST_SKIP() << "pvpython is not installed (python3-paraview)";
    write_gas(folder.path(), 0);
    write_gas(folder.path(), 1);
    write_mesh(folder.path());
    write_averages(folder.path());
    constexpr const char* gas = R"("times": [0, 1e-4], "points": 150000, "cells": 1, "bounds": [0, 1, 0, 2, 1, 2],
        "point_arrays": {"speed": [0, 999], "species": [0, 2], "identity": [0, 149999]})";
    constexpr const char* mesh =
        R"("points": 8, "cells": 4, "bounds": [0, 1, 0, 1, 0, 1], "point_arrays": {"velocity": [1, 1, -2, -2, 3, 3]},
        "cell_arrays": {"von_mises": [1e6, 4e6], "part": [0, 7]})";
    constexpr const char* cells = R"("times": [0.125], "points": 24, "cells": 6, "bounds": [-0.75, 0.75, 0.125, 0.625, 2, 4],
        "point_arrays": {"x_index": [0, 3], "velocity": [1, 1, 2, 2, 0, 1]})";
    replace_file(folder / "expected.json", fmt::format(R"([{{"file": "gas.hdf.series", {0}}}, {{"file": "gas_small.hdf.series", {0}}},
        {{"file": "structure.hdf.series", "times": [0, 0.5, 2.5], {1}}}, {{"file": "structure_000001.hdf", {1}}},
        {{"file": "cells.hdf.series", {2}}}, {{"file": "empty.hdf.series", "times": [0], "points": 0, "cells": 0}}])",
                                                       gas, mesh, cells));
    const int code = shell(fmt::format("pvpython '{}/tools/check_paraview.py' '{}'", CORPUSCLE_SOURCE_DIR, folder.path().string()),
                           folder / "printed", text);
    EXPECT_EQ(code, 0) << text;
    EXPECT_EQ(text.find("ERR|"), std::string::npos) << text;
    EXPECT_NE(text.find("empty.hdf.series: as expected"), std::string::npos) << text;
}

TEST(ParaView, DrawsAllFamiliesFromOneFile)
{
    const ScratchFolder folder;
    std::string text;
    if (shell("command -v pvpython && command -v xvfb-run && command -v xauth", folder / "printed", text) != 0) {
        GTEST_SKIP() << "pvpython (python3-paraview), xvfb or xauth is not installed";
    }
    write_gas(folder.path(), 0);
    write_mesh(folder.path());
    write_averages(folder.path());
    write_view_script(folder.path());
    // A second script runs the first as ParaView does, and says what came of it.
    replace_file(folder / "check.py", fmt::format(R"(import os
from paraview import simple
exec(open('{0}/view.py').read())
sources = sorted(name for name, _ in simple.GetSources())
times = list(simple.GetTimeKeeper().TimestepValues)
simple.SaveScreenshot('{0}/view.png')
print(sources, times, os.path.getsize('{0}/view.png') > 1000, flush=True)
os._exit(0)
)",
                                                  folder.path().string()));
    const std::string run = fmt::format("xvfb-run -a -s '-screen 0 1024x768x24' pvpython '{}/check.py'", folder.path().string());
    int code = shell(run, folder / "printed", text);
    // A display made on a busy machine is sometimes gone before ParaView opens its window: that says nothing of our files.
    const auto no_window = [&] { return code != 0 && text.find("CreateAWindow") != std::string::npos; };
    for (int again = 0; again < 3 && no_window(); ++again) code = shell(run, folder / "printed", text);
    if (no_window()) GTEST_SKIP() << "ParaView cannot open a window here";
    EXPECT_EQ(code, 0) << text;
    EXPECT_NE(text.find("['cells', 'empty', 'gas', 'structure'] [0.0, 0.0001, 0.125, 0.5, 2.5] True"), std::string::npos) << text;
    EXPECT_EQ(text.find("Error"), std::string::npos) << text;
    EXPECT_EQ(text.find("ERR|"), std::string::npos) << text;
}

}  // namespace
}  // namespace corpuscle
