"""STEP files as other programs write them: units, schemas, assemblies, surfaces, names, colours."""

import io
import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import BRepBuilderAPI_NurbsConvert
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeTorus
from OCP.gp import gp_Pnt, gp_Trsf, gp_Vec
from OCP.Interface import Interface_Static
from OCP.Quantity import Quantity_Color, Quantity_TypeOfColor
from OCP.STEPCAFControl import STEPCAFControl_Writer
from OCP.STEPControl import STEPControl_Controller, STEPControl_StepModelType, STEPControl_Writer
from OCP.TCollection import TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Edge, TopoDS_Shape, TopoDS_Shell
from OCP.XCAFDoc import XCAFDoc_ColorType, XCAFDoc_DocumentTool

from gaussiancad_core.comparison.comparing import compare_models
from gaussiancad_core.comparison.comparison_options import CompareOptions, Protocol
from gaussiancad_core.comparison.comparison_report import Comparison
from gaussiancad_core.comparison.comparison_text import comparison_text
from gaussiancad_core.comparison.model_files import Content, Model, read_model
from gaussiancad_core.errors import UnreadableError
from gaussiancad_core.kernel.brep import compound_of, edges_of, faces_of
from gaussiancad_core.kernel.brep_files import write_step

BOX_MM3 = 30.0 * 20.0 * 10.0
BOX_MM2 = 2.0 * (30.0 * 20.0 + 20.0 * 10.0 + 30.0 * 10.0)

AS_IS = STEPControl_StepModelType.STEPControl_AsIs
SURFACES = STEPControl_StepModelType.STEPControl_ShellBasedSurfaceModel


def box(x: float = 0.0, *, wide: float = 30.0) -> TopoDS_Shape:
    """A box of 20 x 10 mm section that starts at ``x``."""
    return BRepPrimAPI_MakeBox(gp_Pnt(x, 0.0, 0.0), wide, 20.0, 10.0).Shape()


def placed(shape: TopoDS_Shape, x: float) -> TopoDS_Shape:
    """The same body at another place, as an assembly repeats it."""
    motion = gp_Trsf()
    motion.SetTranslation(gp_Vec(x, 0.0, 0.0))
    return shape.Moved(TopLoc_Location(motion))


@pytest.fixture
def settings() -> Iterator[None]:
    """OpenCASCADE keeps what it writes for the whole process: they are put back."""
    STEPControl_Controller.Init_s()
    names = ("write.step.unit", "write.step.schema")
    before = {name: Interface_Static.CVal_s(name) for name in names}
    yield
    for name, value in before.items():
        Interface_Static.SetCVal_s(name, value)


def written(path: Path, shape: TopoDS_Shape, mode: STEPControl_StepModelType = AS_IS) -> Path:
    """A file by OpenCASCADE's own writer."""
    writer, stream = STEPControl_Writer(), io.BytesIO()
    writer.Transfer(shape, mode)
    writer.WriteStream(stream)
    path.write_bytes(stream.getvalue())
    return path


TO_AP203 = (
    (rb"FILE_SCHEMA\s*\(.*?\);", b"FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));"),
    (rb"'automotive_design',\d+", b"'config_control_design',1994"),
    (
        rb"'core data for automotive mechanical design\s*processes'",
        b"'configuration controlled 3D'",
    ),
    (rb"=\s*PRODUCT_CONTEXT\(", b"= MECHANICAL_CONTEXT("),
    (rb"=\s*PRODUCT_DEFINITION_CONTEXT\(", b"= DESIGN_CONTEXT("),
    (
        rb"=\s*PRODUCT_DEFINITION_FORMATION\((.*?)\);",
        rb"= PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE(\1,.NOT_KNOWN.);",
    ),
)
"""What of a file by AP214 is different by AP203.  OpenCASCADE's own writer of AP203 asks the system
for the computer's name, and ends the process where that has no address."""


def by_ap203(path: Path) -> Path:
    """The file, of which AP214 was the schema."""
    content = path.read_bytes()
    for pattern, replacement in TO_AP203:
        content, count = re.subn(pattern, replacement, content, flags=re.DOTALL)
        assert count == 1
    path.write_bytes(content)
    return path


def compared(result: Model, reference: Model) -> Comparison:
    """All protocols, few points."""
    asked = CompareOptions(points=500, protocols=tuple(Protocol))
    found, _ = compare_models(result, reference, asked)
    assert comparison_text(found)
    return found


def codes(found: Comparison) -> list[str]:
    """What is warned of."""
    return [remark.code for remark in found.warnings]


@pytest.mark.usefixtures("settings")
@pytest.mark.parametrize("schema", ["AP203", "AP214IS", "AP242DIS"])
@pytest.mark.parametrize(
    ("unit", "word"),
    [("INCH", b"'INCH'"), ("FT", b"'FOOT'"), ("M", b"($,.METRE.)"), ("CM", b"(.CENTI.,.METRE.)")],
)
def test_units_are_converted_whatever_the_schema(
    tmp_path: Path, unit: str, word: bytes, schema: str
) -> None:
    Interface_Static.SetCVal_s("write.step.unit", unit)
    written_by = "AP214IS" if schema == "AP203" else schema
    Interface_Static.SetCVal_s("write.step.schema", written_by)
    path = written(tmp_path / "part.step", box())
    if schema == "AP203":
        by_ap203(path)
    assert word in path.read_bytes()
    model = read_model(path)
    assert model.exact.valid and model.closed
    assert model.exact.volume_mm3 == pytest.approx(BOX_MM3, rel=1e-8)
    assert model.mesh.bounds == pytest.approx(np.array([[0, 0, 0], [30, 20, 10]]), abs=1e-7)


def test_a_file_that_lies_about_its_unit_is_told(tmp_path: Path) -> None:
    """Numbers in inches under a header in millimetres."""
    path = tmp_path / "inches.step"
    write_step(BRepPrimAPI_MakeBox(30.0 / 25.4, 20.0 / 25.4, 10.0 / 25.4).Shape(), path)
    truth = tmp_path / "truth.step"
    write_step(box(), truth)
    found = compared(read_model(path), read_model(truth))
    assert found.unit_factor == pytest.approx(25.4)
    assert codes(found) == ["unit-mismatch"]


def test_names_and_colours_do_not_matter(tmp_path: Path) -> None:
    document = TDocStd_Document(TCollection_ExtendedString("MDTV-XCAF"))
    shapes = XCAFDoc_DocumentTool.ShapeTool_s(document.Main())
    colours = XCAFDoc_DocumentTool.ColorTool_s(document.Main())
    body = box()
    label = shapes.AddShape(compound_of([body, placed(body, 50.0)]), True)
    TDataStd_Name.Set_s(label, TCollection_ExtendedString("Gehäuse – 支架"))
    red = Quantity_Color(1.0, 0.0, 0.0, Quantity_TypeOfColor.Quantity_TOC_RGB)
    colours.SetColor(body, red, XCAFDoc_ColorType.XCAFDoc_ColorSurf)
    writer, stream = STEPCAFControl_Writer(), io.BytesIO()
    writer.Transfer(document, AS_IS)
    writer.WriteStream(stream)
    path = tmp_path / "colours.step"
    path.write_bytes(stream.getvalue())
    text = path.read_bytes()
    assert b"COLOUR_RGB" in text or b"DRAUGHTING_PRE_DEFINED_COLOUR" in text
    assert b"NEXT_ASSEMBLY_USAGE_OCCURRENCE" in text
    model = read_model(path)
    assert (model.exact.faces, model.exact.united, model.exact.left_out) == (12, 0, 0)
    assert model.exact.volume_mm3 == pytest.approx(2.0 * BOX_MM3)
    found = compared(model, model)
    assert codes(found) == []
    assert found.result.betti == (2, 0, 0)


def test_solids_that_touch_are_measured_as_one(tmp_path: Path) -> None:
    both = read_model(written(tmp_path / "two.step", compound_of([box(), box(30.0, wide=5.0)])))
    one = read_model(written(tmp_path / "one.step", box(wide=35.0)))
    assert both.closed
    assert (both.exact.united, both.exact.faces) == (2, 12)
    assert both.exact.volume_mm3 == pytest.approx(one.exact.volume_mm3)
    assert both.exact.area_mm2 == pytest.approx(one.exact.area_mm2)
    found = compared(both, one)
    assert codes(found) == ["solids-united"]
    assert found.engineering.agreement == 1.0
    assert found.engineering.volume_share == pytest.approx(0.0, abs=1e-12)
    assert found.result.betti == (1, 0, 0)


def test_solids_that_overlap_count_once(tmp_path: Path) -> None:
    model = read_model(written(tmp_path / "two.step", compound_of([box(), box(20.0)])))
    assert model.exact.united == 2
    assert model.exact.volume_mm3 == pytest.approx(BOX_MM3 * 5.0 / 3.0)


def test_solids_that_touch_along_an_edge_stay_two(tmp_path: Path) -> None:
    corner = BRepPrimAPI_MakeBox(gp_Pnt(30.0, 20.0, 0.0), 5.0, 10.0, 10.0).Shape()
    model = read_model(written(tmp_path / "two.step", compound_of([box(), corner])))
    assert model.closed
    found = compared(model, model)
    assert codes(found) == []
    assert found.result.betti == (2, 0, 0)


def test_surfaces_that_close_up_are_a_solid(tmp_path: Path) -> None:
    model = read_model(written(tmp_path / "surfaces.step", box(), SURFACES))
    assert model.exact.content is Content.SEWN
    assert model.exact.valid and model.closed
    assert model.exact.volume_mm3 == pytest.approx(BOX_MM3)
    assert codes(compared(model, model)) == ["surfaces-sewn"] * 2


@pytest.mark.parametrize("loose", [False, True])
def test_open_surfaces_are_measured_as_they_are(tmp_path: Path, loose: bool) -> None:
    """Five sides of a box, in one shell or each by itself."""
    faces = faces_of(box())[1:]
    shell = TopoDS_Shell()
    builder = BRep_Builder()
    builder.MakeShell(shell)
    for face in faces:
        builder.Add(shell, face)
    shape = compound_of(faces) if loose else shell
    model = read_model(written(tmp_path / "open.step", shape))
    assert model.exact.content is Content.SURFACES
    assert (model.exact.faces, model.exact.valid, model.closed) == (5, False, False)
    assert model.exact.area_mm2 == pytest.approx(BOX_MM2 - 200.0)
    whole = read_model(written(tmp_path / "whole.step", box()))
    found = compared(model, whole)
    assert codes(found) == ["surfaces-only"]
    assert found.result.volume_mm3 is None
    assert found.engineering.result_to_reference.greatest == pytest.approx(0.0, abs=1e-9)
    # Whoever has the whole box has one side more, up to 5 mm from the nearest of the others.
    assert 4.0 < found.engineering.reference_to_result.greatest <= 5.0
    assert found.deepcad.invalid is not None


def test_faces_beside_solids_are_left_out_and_told(tmp_path: Path) -> None:
    side = faces_of(placed(box(), 50.0))[0]
    model = read_model(written(tmp_path / "both.step", compound_of([box(), side])))
    assert (model.exact.faces, model.exact.left_out) == (6, 1)
    assert model.mesh.bounds[1, 0] == pytest.approx(30.0)
    assert codes(compared(model, model)) == ["surfaces-left-out"] * 2


def test_curves_alone_are_no_model(tmp_path: Path) -> None:
    edges: list[TopoDS_Edge] = edges_of(box())
    path = written(tmp_path / "wires.step", compound_of(edges))
    with pytest.raises(UnreadableError) as caught:
        read_model(path)
    assert caught.value.code == "not-a-solid"
    assert "\n" not in caught.value.message


def test_free_form_faces_have_their_exact_volume(tmp_path: Path) -> None:
    torus = BRepPrimAPI_MakeTorus(10.0, 3.0).Shape()
    path = written(tmp_path / "torus.step", BRepBuilderAPI_NurbsConvert(torus, True).Shape())
    model = read_model(path)
    assert model.exact.volume_mm3 == pytest.approx(2.0 * np.pi**2 * 10.0 * 9.0, rel=1e-8)
    assert model.exact.area_mm2 == pytest.approx(4.0 * np.pi**2 * 10.0 * 3.0, rel=1e-8)
    assert model.mesh.volume == pytest.approx(model.exact.volume_mm3, rel=1e-3)
    # Triangles keep to the surface between the edges of its faces, too.
    middles = model.mesh.corners.mean(axis=1)
    around = np.hypot(np.hypot(middles[:, 0], middles[:, 1]) - 10.0, middles[:, 2])
    assert np.abs(around - 3.0).max() < 1.5 * model.exact.deflection_mm
