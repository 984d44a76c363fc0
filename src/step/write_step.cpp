// SPDX-License-Identifier: GPL-3.0-or-later
#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_ProgressIndicator.hxx>
#include <STEPConstruct.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>
#include <algorithm>
#include <array>
#include <mutex>
#include <sstream>

#include "croquis/base/error.h"
#include "step/step_file.h"
#include "step/step_shape.h"

namespace croquis {
namespace {

/// OpenCASCADE's settings are the process's.
std::mutex& settings_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// Passes progress on, and the request to stop.
class StepProgress final : public Message_ProgressIndicator {
 public:
  explicit StepProgress(const Progress& progress) : progress_(progress) {}
  Standard_Boolean UserBreak() override { return progress_.cancelled(); }

 protected:
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

 private:
  const Progress& progress_;
};

Handle(TCollection_HAsciiString) text(const std::string& words) { return new TCollection_HAsciiString(words.c_str()); }

/// Coordinates are written as they are: the unit of the file is the one that OpenCASCADE is to take them in.
void apply_settings(const StepOptions& options) {
  constexpr std::array<const char*, 4> units = {"MM", "CM", "M", "INCH"};
  STEPControl_Controller::Init();
  Message::DefaultMessenger()->ChangePrinters().Clear();  // it prints statistics, to standard output
  const char* unit = units[static_cast<std::size_t>(options.unit)];
  Interface_Static::SetCVal("xstep.cascade.unit", unit);
  Interface_Static::SetCVal("write.step.unit", unit);
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
}

void set_names(const StepShape& shape, STEPControl_Writer& writer) {
  const Handle(Transfer_FinderProcess) finder = writer.WS()->TransferWriter()->FinderProcess();
  for (const auto& [part, name] : shape.names) {
    // Kept by the direction in which a part came first.
    for (const TopoDS_Shape& way : {part, part.Reversed()}) {
      const Handle(StepRepr_RepresentationItem) item = STEPConstruct::FindEntity(finder, way);
      if (!item.IsNull()) item->SetName(text(name));
    }
  }
}

/// OpenCASCADE numbers products as long as the process runs.
void set_product(const Handle(StepData_StepModel) & model, const std::string& name) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const Handle(StepBasic_Product) product = Handle(StepBasic_Product)::DownCast(model->Entity(i));
    if (product.IsNull()) continue;
    product->SetId(text(name));
    product->SetName(text(name));
  }
}

/// The same solid gives the same bytes, so the time is a fixed one.
void set_header(const Handle(StepData_StepModel) & model, const std::string& name) {
  APIHeaderSection_MakeHeader header(model);
  header.SetName(text(name));
  header.SetTimeStamp(text("1970-01-01T00:00:00"));
  header.SetAuthorValue(1, text(""));
  header.SetOrganizationValue(1, text(""));
  header.SetOriginatingSystem(text("Croquis"));
}

std::string bytes_of(STEPControl_Writer& writer) {
  StepData_StepWriter file(writer.Model());
  file.FloatWriter().SetFormat("%.16E");  // reads back exactly
  file.SendModel(Handle(StepData_Protocol)::DownCast(writer.WS()->Protocol()));
  std::ostringstream out;
  file.Print(out);
  return std::move(out).str();
}

std::string transferred(const StepShape& shape, const StepOptions& options, Progress& progress) {
  const std::scoped_lock lock(settings_mutex());
  apply_settings(options);
  STEPControl_Writer writer;
  const Handle(StepProgress) indicator = new StepProgress(progress);
  const IFSelect_ReturnStatus status =
      writer.Transfer(shape.shape, STEPControl_AsIs, Standard_True, indicator->Start());
  progress.check();
  if (status != IFSelect_RetDone) {
    throw Error(
        make_error(Category::Geometry, "E_STEP_FILE", "OpenCASCADE can't write this solid as STEP: write a mesh."));
  }
  set_names(shape, writer);
  set_product(writer.Model(), options.name);
  set_header(writer.Model(), options.name);
  return bytes_of(writer);
}

double greatest_error(const std::vector<std::vector<BicubicFit>>& fits) {
  double greatest = 0;
  for (const auto& face : fits) {
    for (const BicubicFit& fit : face) greatest = std::max(greatest, fit.error);
  }
  return greatest;
}

}  // namespace

std::string why_no_step() { return {}; }

StepFile write_step(const Brep& brep, const StepOptions& options, Progress& progress) try {
  if (brep.faces.empty()) {
    throw Error(make_error(Category::Geometry, "E_STEP_FILE",
                           "A solid without faces can't be written as STEP: see the other findings."));
  }
  Progress fitting = progress.step("fit surfaces", 0.5);
  const std::vector<std::vector<BicubicFit>> fits = fit_patches(brep, fitting, options.fit);
  Progress writing = progress.step("write STEP", 0.5);
  const StepShape shape = step_shape(brep, fits, options.face_names);
  writing.report(0.3);
  StepFile file{transferred(shape, options, writing), shape.faces, shape.edges, greatest_error(fits)};
  progress.report(1);
  return file;
} catch (const Standard_Failure& failure) {
  throw Error(make_error(
      Category::Geometry, "E_STEP_FILE",
      std::string("OpenCASCADE can't write this solid as STEP (") + failure.GetMessageString() + "): write a mesh."));
}

}  // namespace croquis
