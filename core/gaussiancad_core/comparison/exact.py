"""What the exact surfaces of a B-Rep tell, where triangles would only come near."""

from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepGProp import BRepGProp
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.GProp import GProp_GProps
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.comparison.models import ExactFacts
from gaussiancad_core.drawing.brep import faces_of, soundness


def exact_facts(shape: TopoDS_Shape, deflection: float) -> ExactFacts:
    """Measure a shape whose triangles are at most ``deflection`` mm away from it."""
    sound = soundness(shape)
    surface = GProp_GProps()
    BRepGProp.SurfaceProperties_s(shape, surface)
    flat = all(
        BRepAdaptor_Surface(face).GetType() == GeomAbs_SurfaceType.GeomAbs_Plane
        for face in faces_of(shape)
    )
    return ExactFacts(
        valid=sound.valid,
        closed=sound.closed,
        faces=sound.faces,
        volume_mm3=abs(sound.volume_mm3),
        area_mm2=float(surface.Mass()),
        # Where all faces are planes the triangles are the surface itself.
        deflection_mm=0.0 if flat else deflection,
    )
