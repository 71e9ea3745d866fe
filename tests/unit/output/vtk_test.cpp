#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "base/error.hpp"
#include "output/replace_file.hpp"
#include "output/vtk/cells.hpp"
#include "output/vtk/image.hpp"
#include "output/vtk/points.hpp"
#include "output/vtk/series.hpp"
#include "output/vtk/view_script.hpp"
#include "unit/scratch_folder.hpp"

namespace corpuscle {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void expect_header(const Hdf5File& file, const std::string& type)
{
    EXPECT_THAT(file.integer_attribute("/VTKHDF", "Version"), ElementsAre(1, 0));
    EXPECT_EQ(file.text_attribute("/VTKHDF", "Type"), type);
}

TEST(WritePoints, MakesOneCellOfAllParticles)
{
    const ScratchFolder folder;
    std::vector<Vector3f> positions{{1, 2, 3}, {4, 5, 6}};
    std::vector<double> speed{7, 8};
    const FieldSet fields{"gas", {stored_field("position", "m", "", positions), stored_field("speed", "m/s", "", speed)}};
    write_points(folder / "gas.hdf", fields.fields[0], fields);

    const Hdf5File file = Hdf5File::open(folder / "gas.hdf");
    expect_header(file, "UnstructuredGrid");
    EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfPoints"), ElementsAre(2));
    EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfCells"), ElementsAre(1));
    EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfConnectivityIds"), ElementsAre(2));
    EXPECT_THAT(file.read_integers("/VTKHDF/Connectivity"), ElementsAre(0, 1));
    EXPECT_THAT(file.read_integers("/VTKHDF/Offsets"), ElementsAre(0, 2));
    EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(2));
    EXPECT_THAT(file.read_numbers("/VTKHDF/Points"), ElementsAre(1, 2, 3, 4, 5, 6));
    EXPECT_EQ(file.shape("/VTKHDF/Points"), (Hdf5Shape{Hdf5Type::float32, {2, 3}}));
    EXPECT_THAT(file.members("/VTKHDF/PointData"), ElementsAre("speed"));
    EXPECT_THAT(file.read_numbers("/VTKHDF/PointData/speed"), ElementsAre(7, 8));
}

TEST(WritePoints, TakesAnEmptyCloud)
{
    const ScratchFolder folder;
    std::vector<Vector3f> none;
    std::vector<float> speed;
    write_points(folder / "gas.hdf", stored_field("position", "m", "", none), {"gas", {stored_field("speed", "m/s", "", speed)}});
    const Hdf5File file = Hdf5File::open(folder / "gas.hdf");
    EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfCells"), ElementsAre(0));
    EXPECT_THAT(file.read_integers("/VTKHDF/Offsets"), ElementsAre(0));
    EXPECT_EQ(file.shape("/VTKHDF/PointData/speed").extents, std::vector<std::uint64_t>{0});
}

TEST(WritePoints, RefusesAFieldOnOtherThings)
{
    const ScratchFolder folder;
    std::vector<Vector3f> positions(2);
    std::vector<float> speed(3);
    try {
        write_points(folder / "gas.hdf", stored_field("position", "m", "", positions), {"gas", {stored_field("speed", "m/s", "", speed)}});
        FAIL() << "a field of 3 values was written on 2 points";
    } catch (const Error& error) {
        EXPECT_THAT(error.problem(), HasSubstr("'speed' of 'gas' has 3 values for 2"));
    }
}

TEST(WriteCells, WritesAMixedMesh)
{
    const ScratchFolder folder;
    std::vector<Vector3d> nodes(8);
    std::vector<MeshElement> elements{{ElementShape::quadrilateral, {0, 1, 2, 3}},
                                      {ElementShape::triangle, {4, 5, 6}},
                                      {ElementShape::tetrahedron, {0, 1, 2, 4}},
                                      {ElementShape::hexahedron, {0, 1, 2, 3, 4, 5, 6, 7}}};
    std::vector<double> stress{1, 2, 3, 4};
    std::vector<Vector3d> velocity(8, {1, 0, -1});
    const GridFields fields{{"nodes", {stored_field("velocity", "m/s", "", velocity)}},
                            {"elements", {stored_field("von_mises", "Pa", "", stress)}}};
    write_cells(folder / "plate.hdf", stored_field("position", "m", "", nodes), cell_grid(elements), fields);

    const Hdf5File file = Hdf5File::open(folder / "plate.hdf");
    expect_header(file, "UnstructuredGrid");
    EXPECT_THAT(file.read_integers("/VTKHDF/Types"), ElementsAre(9, 5, 10, 12));
    EXPECT_THAT(file.read_integers("/VTKHDF/Offsets"), ElementsAre(0, 4, 7, 11, 19));
    EXPECT_THAT(file.read_integers("/VTKHDF/NumberOfConnectivityIds"), ElementsAre(19));
    EXPECT_THAT(file.read_integers("/VTKHDF/Connectivity"), ElementsAre(0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 4, 0, 1, 2, 3, 4, 5, 6, 7));
    EXPECT_EQ(file.shape("/VTKHDF/Points").type, Hdf5Type::float64);
    EXPECT_EQ(file.shape("/VTKHDF/PointData/velocity").extents, (std::vector<std::uint64_t>{8, 3}));
    EXPECT_THAT(file.read_numbers("/VTKHDF/CellData/von_mises"), ElementsAre(1, 2, 3, 4));
    EXPECT_EQ(file.text_attribute("/VTKHDF/CellData/von_mises", "unit"), "Pa");
}

TEST(WriteCells, RefusesAGridThatDoesNotFit)
{
    const ScratchFolder folder;
    std::vector<Vector3d> nodes(3);
    const Field positions = stored_field("position", "m", "", nodes);
    CellGrid grid;
    grid.add(ElementShape::triangle, std::array<std::uint32_t, 3>{0, 1, 3});
    EXPECT_THROW(write_cells(folder / "a.hdf", positions, grid, {}), Error);
    grid.connectivity.back() = 2;
    EXPECT_NO_THROW(write_cells(folder / "a.hdf", positions, grid, {}));
    grid.offsets.back() = 4;
    EXPECT_THROW(write_cells(folder / "a.hdf", positions, grid, {}), Error);
}

TEST(WriteImage, LaysCellAveragesOutAsZyxAtTheCellCentres)
{
    const ScratchFolder folder;
    const ImageGrid grid = cell_centers({3, 2, 1}, {-1, -2, -3}, {0.5, 0.25, 1});
    std::vector<float> pressure{0, 1, 2, 3, 4, 5};
    std::vector<Vector3f> flow(6, {1, 2, 3});
    const FieldSet fields{"cells", {stored_field("pressure", "Pa", "", pressure), stored_field("velocity", "m/s", "", flow)}};
    write_image(folder / "cells.hdf", grid, fields);

    const Hdf5File file = Hdf5File::open(folder / "cells.hdf");
    expect_header(file, "ImageData");
    EXPECT_THAT(file.integer_attribute("/VTKHDF", "WholeExtent"), ElementsAre(0, 2, 0, 1, 0, 0));
    EXPECT_THAT(file.number_attribute("/VTKHDF", "Origin"), ElementsAre(-0.75, -1.875, -2.5));
    EXPECT_THAT(file.number_attribute("/VTKHDF", "Spacing"), ElementsAre(0.5, 0.25, 1));
    EXPECT_EQ(file.shape("/VTKHDF/PointData/pressure").extents, (std::vector<std::uint64_t>{1, 2, 3}));
    EXPECT_EQ(file.shape("/VTKHDF/PointData/velocity").extents, (std::vector<std::uint64_t>{1, 2, 3, 3}));
    EXPECT_THAT(file.read_numbers("/VTKHDF/PointData/pressure"), ElementsAre(0, 1, 2, 3, 4, 5));
    EXPECT_THROW(write_image(folder / "b.hdf", cell_centers({0, 1, 1}, {}, {1, 1, 1}), {}), Error);
    EXPECT_THROW(write_image(folder / "b.hdf", cell_centers({1, 1, 1}, {}, {1, 0, 1}), {}), Error);
    EXPECT_THROW(write_image(folder / "b.hdf", cell_centers({2, 2, 2}, {}, {1, 1, 1}), fields), Error);
}

void write_dump(VtkSeries& series, double time)
{
    series.add(time, [](const std::filesystem::path& path) { std::ofstream(path) << "dump"; });
}

TEST(VtkSeries, ListsEveryFileWithItsTime)
{
    const ScratchFolder folder;
    VtkSeries series(folder.path(), "gas");
    write_dump(series, 0);
    write_dump(series, 1.25e-4);
    EXPECT_EQ(read_file(folder / "gas_000001.hdf"), "dump");
    EXPECT_FALSE(std::filesystem::exists(folder / "gas_000001.hdf.part"));
    const std::string list = read_file(series.list());
    EXPECT_THAT(list, HasSubstr("\"file-series-version\": \"1.0\""));
    EXPECT_THAT(list, HasSubstr("\"gas_000001.hdf\""));
    EXPECT_THAT(list, HasSubstr("0.000125"));
}

TEST(VtkSeries, LeavesTheListAloneWhenADumpFails)
{
    const ScratchFolder folder;
    VtkSeries series(folder.path(), "gas");
    write_dump(series, 0);
    const std::string before = read_file(series.list());
    EXPECT_THROW(series.add(1, [](const std::filesystem::path&) { throw Error("the disk is full"); }), Error);
    EXPECT_EQ(read_file(series.list()), before);
    EXPECT_EQ(series.entries().size(), 1U);
}

TEST(VtkSeries, GoesOnAfterARestart)
{
    const ScratchFolder folder;
    VtkSeries first(folder.path(), "gas");
    for (int i = 0; i < 5; ++i) write_dump(first, 0.1 * i);

    VtkSeries second(folder.path(), "gas");
    second.resume(0.1 * 2);
    ASSERT_EQ(second.entries().size(), 3U);
    EXPECT_DOUBLE_EQ(second.entries().back().time, 0.2);
    EXPECT_FALSE(std::filesystem::exists(folder / "gas_000003.hdf"));
    write_dump(second, 0.35);
    EXPECT_EQ(second.entries().back().name, "gas_000003.hdf");

    VtkSeries third(folder.path(), "gas");
    third.resume(10);
    EXPECT_EQ(third.entries().size(), 4U);
}

TEST(VtkSeries, ResumesFromNothingAndRefusesNonsense)
{
    const ScratchFolder folder;
    VtkSeries series(folder.path(), "gas");
    series.resume(1);
    EXPECT_THAT(series.entries(), IsEmpty());
    std::ofstream(series.list()) << "{ \"files\": 3";
    EXPECT_THROW(series.resume(1), Error);
}

TEST(ViewScript, KnowsItsFolder)
{
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "a \"b\"");
    write_view_script(folder / "a \"b\"");
    const std::string script = read_file(folder / "a \"b\"/view.py");
    EXPECT_TRUE(script.starts_with("WRITTEN_IN = \"" + folder.path().string() + "/a \\\"b\\\"\"\n")) << script;
    EXPECT_THAT(script, HasSubstr("*.hdf.series"));
}

}  // namespace
}  // namespace corpuscle
