// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/mutation_inputs.h"

#include <memory>
#include <set>
#include <utility>

#include "croquis/base/text.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/svg_drawing.h"
#include "fuzz/project_mutation.h"
#include "fuzz/text_mutation.h"

namespace croquis::test {
namespace {

const std::string corpus = "tests/fuzz/corpus/mutate/";
const std::string examples = "examples/data/";

std::string root() { return CROQUIS_SOURCE_DIR; }

std::string root_file(const std::string& name) { return root() + "/" + name; }

TextSyntax syntax_of(const std::filesystem::path& file) {
  if (file.extension() == ".svg") return TextSyntax::Xml;
  return file.extension() == ".json" ? TextSyntax::Json : TextSyntax::Lines;
}

/// Coarse, so that many can be made.
const std::vector<std::string> sketch_commands = {
    "inflate {} -o o.obj --resolution 20 --threads 1",
    "inflate {} -o o.stl --resolution 20 --preset clean --crossings refuse --min-gap 0.5",
    "inflate {} -o o.obj --resolution 16 --preset clean --crossings front --attach auto --labels l.svg",
    "inflate {} -o o.ply --resolution 20 --preset tablet --weight-curvature 0.01 --skeleton s.obj"};

const std::vector<std::string> perspective_commands = {
    "perspective {} -o o.obj --mode auto --tolerance 0.01", "perspective {} -o o.stl --mode 2 --fix --smooth-angle 30",
    "perspective {} -o o.obj --mode 3 --known-point 474,508=0,0,0 --scale e1=4 --curves c.obj --camera c.json",
    "perspective {} -o o.obj --mode 1 --field-of-view 50.5 --patches p.json --ignore e3"};

const std::vector<std::string> network_commands = {
    "surface {} -o o.obj --samples 4", "surface {} -o o.ply --samples 3 --mode position --domain uniform",
    "surface {} -o o.obj --mode paper --samples 4 --fullness 0.5", "surface {} -o o.stl --tolerance 0.05"};

const std::vector<std::string> cage_commands = {
    "subdivide {} -o o.obj --levels 2", "subdivide {} -o o.ply --levels 1 --scheme catmull-clark --limit",
    "subdivide {} -o o.obj --levels 1 --scheme loop --tags-out t.json --chain-ends retract",
    "subdivide {} -o o.obj --levels 2 --sharp-angle 40.5 --preset paper --chain-ends pin", "fair {} -o o.obj"};

const std::vector<std::string> scan_commands = {"fill {} -o o.obj",
                                                "fill {} -o o.ply --fairness smooth --select all --weld 1e-6",
                                                "fill {} -o o.obj --fairness flat --drop-bad --bulge 0.5",
                                                "fill {} --list",
                                                "fill {} -o o.obj --mode remesh --cell 8",
                                                "info {} --self-intersections",
                                                "check {}",
                                                "convert {} -o o.stl",
                                                "convert {} -o o.glb",
                                                "convert {} -o o.off --precision 5"};

std::vector<std::string> edit_commands(const std::string& mesh) {
  return {"edit {root}/examples/data/" + mesh + " -o o.obj --do @{}",
          "edit {root}/examples/data/" + mesh + " -o o.ply --do @{} --threads 1"};
}

std::vector<std::string> tag_commands() {
  return {"subdivide {root}/examples/data/cube_corner.obj -o o.obj --levels 1 --tags {}",
          "subdivide {root}/examples/data/cube_corner.obj -o o.obj --levels 2 --scheme catmull-clark --tags {}"};
}

Node source(const std::string& name, Value value) {
  Node node;
  node.name = name;
  node.source = std::move(value);
  return node;
}

Node operation(const std::string& id, const std::string& input, NodeId from, const std::string& output,
               ParameterValues parameters) {
  Node node;
  node.name = id;
  node.operation = id;
  node.inputs[input] = {from, output};
  node.parameters = std::move(parameters);
  return node;
}

/// A chain for each kind of source; scaled and moved here and there.
Document every_kind_of_node() {
  Progress progress;
  const auto bytes = [](const std::string& name) { return read_file(root_file(name)); };
  auto sketch = read_svg_drawing(bytes(corpus + "limb.svg"), "limb.svg", progress).drawing;
  auto sheet = read_perspective_svg(bytes(corpus + "box.svg"), "box.svg", progress).drawing;
  auto network = read_attribute_network(bytes(examples + "surface/tri_point.json"), "tri_point.json").network;
  auto cage =
      read_mesh({bytes(examples + "cube_corner.obj"), MeshFormat::Obj, "cube_corner.obj", false}, progress).mesh;
  Document document =
      Document()
          .with(source("sketch", std::make_shared<const Drawing>(std::move(sketch))))
          .with(operation("inflate", "drawing", 1, "value", {{"resolution", 25.0}}))
          .with(source("sheet", std::make_shared<const PerspectiveDrawing>(std::move(sheet))))
          .with(operation("perspective", "drawing", 3, "value", {{"smooth-angle", 30.5}}))
          .with(source("network", std::make_shared<const AttributeNetwork>(std::move(network))))
          .with(operation("surface", "network", 5, "value", {{"samples", std::int64_t{3}}}))
          .with(source("cage", std::make_shared<const PolyMesh>(std::move(cage))))
          .with(operation("edit", "mesh", 7, "value", {{"do", std::string("extrude faces=5 distance=0.5")}}))
          .with(operation("subdivide", "cage", 8, "mesh", {{"levels", std::int64_t{1}}}));
  Node moved = *document.find(8);
  moved.transform.linear *= 2.5;
  moved.transform.offset = Vec3(1, 2, 3);
  return document.with(std::move(moved));
}

Arguments arguments_of(std::string command, const std::string& input) {
  Arguments arguments;
  for (const std::string_view part : text_parts(command, " ")) {
    std::string word(part);
    for (const auto& [mark, text] : {std::pair<std::string, std::string>{"{}", input}, {"{root}", root()}}) {
      if (const std::size_t at = word.find(mark); at != std::string::npos) word.replace(at, mark.size(), text);
    }
    arguments.push_back(std::move(word));
  }
  return arguments;
}

/// Meshes of millions of triangles by request would only take the run's time. What is refused anyway stays.
void ask_for_few_samples(Arguments& arguments) {
  constexpr std::uint64_t most = 60, most_allowed = 1024;
  for (std::size_t at = 1; at < arguments.size(); ++at) {
    std::uint64_t samples = 0;
    if (arguments[at - 1] == "--samples" && read_number(arguments[at], samples) && samples > most &&
        samples <= most_allowed)
      arguments[at] = std::to_string(most);
  }
}

}  // namespace

const std::vector<MutationSystem>& mutation_systems() {
  static const std::vector<MutationSystem> systems = {
      {"sketch",
       {{corpus + "limb.svg", sketch_commands},
        {corpus + "rings.svg", sketch_commands},
        {corpus + "bumps.svg", sketch_commands},
        {examples + "linked_rings.svg", sketch_commands}}},
      {"perspective", {{corpus + "box.svg", perspective_commands}, {corpus + "box.json", perspective_commands}}},
      {"network",
       {{examples + "surface/tri_point.json", network_commands},
        {examples + "surface/sail.json", network_commands},
        {examples + "surface/pocket5.json", network_commands},
        {examples + "surface/chair.json", network_commands}}},
      {"cage",
       {{examples + "cube_corner.obj", cage_commands},
        {examples + "bolt_open_chain.obj", cage_commands},
        {examples + "bolt_pinned_square.obj", cage_commands},
        {corpus + "tags.json", tag_commands()}}},
      {"scan", {{corpus + "scan.obj", scan_commands}}},
      {"edits",
       {{corpus + "steps.txt", edit_commands("cube_corner.obj")},
        {corpus + "steps.txt", edit_commands("l_bracket.obj")}}},
      {"project", {{"", {"run {} -o o.obj", "run {} -o o.ply --set subdivide.levels=2"}}}}};
  return systems;
}

MutatedInput write_mutated_input(const MutationSystem& system, std::uint64_t seed,
                                 const std::filesystem::path& folder) {
  Random random(seed);
  const auto one_of = [&](const auto& list) { return list[random.below(static_cast<std::uint32_t>(list.size()))]; };
  const MutationBase base = one_of(system.bases);
  const std::string extension = base.file.empty() ? ".croq" : std::filesystem::path(base.file).extension().string();
  const std::filesystem::path input = folder / (system.name + "-" + std::to_string(seed) + extension);
  if (base.file.empty()) {
    static const Document document = every_kind_of_node();
    Progress progress;
    save_project(input, {document, {}, {}}, progress);
    mutate_project(input, random);
  } else {
    OutputTransaction transaction;
    transaction.add(input, mutated_text(read_file(root_file(base.file)), syntax_of(input), random));
    transaction.commit();
  }
  std::string command = one_of(base.commands);
  if (random.below(4) == 0) {  // typed parameters, too
    const std::size_t options = std::min(command.find(" -o"), command.size());
    command = command.substr(0, options) + mutated_text(command.substr(options), TextSyntax::Lines, random);
  }
  Arguments arguments = arguments_of(command, input.string());
  ask_for_few_samples(arguments);
  return {input, std::move(arguments)};
}

std::vector<Arguments> commands_on(const MutationSystem& system, const std::filesystem::path& input) {
  std::set<std::string> commands;
  for (const MutationBase& base : system.bases) {
    const std::string extension = base.file.empty() ? ".croq" : std::filesystem::path(base.file).extension().string();
    if (input.extension() == extension) commands.insert(base.commands.begin(), base.commands.end());
  }
  std::vector<Arguments> all;
  for (const std::string& command : commands) all.push_back(arguments_of(command, input.string()));
  return all;
}

}  // namespace croquis::test
