#include "output/vtk/view_script.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "output/replace_file.hpp"

namespace corpuscle {

namespace {

/// The script after the line that says where the files were written.
constexpr std::string_view script = R"py(
# Opens every family of this folder in ParaView: File > Load State, or paraview --script=view.py
import glob
import os

from paraview import simple

# What colours a family, the first of these that it has.
COLORS = ("speed", "velocity", "von_mises", "plastic_strain", "displacement", "pressure", "density")


def folder():
    """The folder of this script, also after it was moved; some ParaViews do not tell a script its own name."""
    own = globals().get("__file__")
    here = os.path.dirname(os.path.abspath(own)) if own else ""
    return here if glob.glob(os.path.join(here, "*.hdf.series")) else WRITTEN_IN


def color(shown, reader):
    """Colours by the first known field, points before cells."""
    for name in COLORS:
        for kind, data in (("POINTS", reader.PointData), ("CELLS", reader.CellData)):
            if name in data.keys():
                simple.ColorBy(shown, (kind, name) if data[name].GetNumberOfComponents() == 1 else (kind, name, "Magnitude"))
                shown.RescaleTransferFunctionToDataRange(False, True)
                return


def show(path, view, last):
    """Opens one family: a cloud as dots, a regular grid in outline, a mesh as a surface with its edges."""
    reader = simple.OpenDataFile(path)
    simple.RenameSource(os.path.basename(path).split(".")[0], reader)
    reader.UpdatePipeline(last)
    info = reader.GetDataInformation()
    shown = simple.Show(reader, view)
    if info.GetDataSetTypeAsString() == "vtkImageData" or os.path.basename(path).startswith("cells."):
        shown.SetRepresentationType("Outline")
        return
    if info.GetNumberOfCells() == 1 and info.GetNumberOfPoints() > 8:
        shown.SetRepresentationType("Points")
        shown.PointSize = 2.0
    else:
        shown.SetRepresentationType("Surface With Edges")
    color(shown, reader)


def last_time(paths):
    """The latest time of all families, so that colours fit what happens and not the state at rest."""
    times = [0.0]
    for path in paths:
        reader = simple.OpenDataFile(path)
        times.extend(getattr(reader, "TimestepValues", None) or [])
        simple.Delete(reader)
    return max(times)


def main():
    paths = sorted(glob.glob(os.path.join(folder(), "*.hdf.series")))
    view = simple.GetActiveViewOrCreate("RenderView")
    last = last_time(paths)
    for path in paths:
        show(path, view, last)
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.ResetCamera(view)
    simple.Render(view)


main()
)py";

/// Text as it may stand between double quotes in Python.
std::string python_text(const std::string& text)
{
    std::string result;
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') result += '\\';
        result += letter;
    }
    return result;
}

}  // namespace

void write_view_script(const std::filesystem::path& folder)
{
    const std::string written_in = std::filesystem::absolute(folder).lexically_normal().string();
    replace_file(folder / "view.py", fmt::format("WRITTEN_IN = \"{}\"\n", python_text(written_in)) + std::string(script.substr(1)));
}

}  // namespace corpuscle
