// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/read_step.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <sstream>

namespace croquis::test {
namespace {

std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum type) {
  TopTools_IndexedMapOfShape found;
  TopExp::MapShapes(shape, type, found);
  return static_cast<std::size_t>(found.Extent());
}

bool all_edges_have_two_faces(const TopoDS_Shape& shape) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of_edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edges);
  for (int e = 1; e <= faces_of_edges.Extent(); ++e) {
    if (faces_of_edges(e).Extent() != 2) return false;
  }
  return true;
}

void look_at_edges(const TopoDS_Shape& shape, ReadSolid& solid) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape, TopAbs_EDGE, edges);
  for (int e = 1; e <= edges.Extent(); ++e) {
    const TopoDS_Edge& edge = TopoDS::Edge(edges(e));
    const BRepAdaptor_Curve curve(edge);
    if (curve.GetType() == GeomAbs_Line) ++solid.lines;
    if (curve.GetType() == GeomAbs_BSplineCurve && curve.IsRational()) ++solid.rational_edges;
  }
}

void look_at_faces(const TopoDS_Shape& shape, ReadSolid& solid) {
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    if (BRepAdaptor_Surface(TopoDS::Face(it.Current())).GetType() == GeomAbs_Plane) ++solid.planes;
  }
}

/// Null where the bytes can't be read.
TopoDS_Shape shape_in(const std::string& bytes) {
  STEPControl_Reader reader;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  std::istringstream stream(bytes);
  if (reader.ReadStream("solid.step", stream) != IFSelect_RetDone || reader.TransferRoots() == 0) return {};
  return reader.OneShape();
}

}  // namespace

ReadSolid read_step(const std::string& bytes) {
  const TopoDS_Shape shape = shape_in(bytes);
  if (shape.IsNull()) return {};
  ReadSolid solid;
  solid.valid = BRepCheck_Analyzer(shape).IsValid();
  solid.closed = all_edges_have_two_faces(shape);
  solid.solids = count(shape, TopAbs_SOLID);
  solid.shells = count(shape, TopAbs_SHELL);
  solid.faces = count(shape, TopAbs_FACE);
  solid.edges = count(shape, TopAbs_EDGE);
  look_at_edges(shape, solid);
  look_at_faces(shape, solid);
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  solid.volume = properties.Mass();
  return solid;
}

double area_in_step(const std::string& bytes) {
  GProp_GProps properties;
  BRepGProp::SurfaceProperties(shape_in(bytes), properties, 1e-12);
  return properties.Mass();
}

}  // namespace croquis::test
