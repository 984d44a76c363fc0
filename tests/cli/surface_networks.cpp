// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/surface_networks.h"

#include <cmath>
#include <numbers>

namespace croquis::test {
namespace {

using Json = nlohmann::json;

void add_node(Json& network, const std::string& id, const Json& place) {
  network["nodes"].push_back({{"id", id}, {"p", place}});
}

void add_line(Json& network, const std::string& id, const std::string& from, const std::string& to) {
  network["curves"].push_back({{"id", id}, {"from", from}, {"to", to}});
}

void add_face(Json& network, const std::string& id, const Json& loop) {
  network["faces"].push_back({{"id", id}, {"loop", loop}});
}

Json& element(Json& network, const char* list, const std::string& id) {
  for (Json& entry : network[list]) {
    if (entry["id"] == id) return entry;
  }
  throw std::out_of_range(id);
}

Json& curve(Json& network, const std::string& id) { return element(network, "curves", id); }
Json& bad_loop(Json& network) { return element(network, "faces", "bad")["loop"]; }

Json changed(const auto& change) {
  Json network = two_faces();
  change(network);
  return network;
}

/// The face "bad" as a half circle of so many straight curves below "ab".
void make_half_circle(Json& network, int count) {
  Json loop{"-ab"};
  std::string before = "a";
  for (int i = 1; i <= count; ++i) {
    const double angle = std::numbers::pi * (1 + static_cast<double>(i) / count);
    const std::string next = i == count ? "b" : "r" + std::to_string(i);
    if (i < count) add_node(network, next, {1 + std::cos(angle), std::sin(angle), 0});
    add_line(network, "s" + std::to_string(i), before, next);
    loop.push_back("+s" + std::to_string(i));
    before = next;
  }
  bad_loop(network) = loop;
}

Json moebius_strip() {
  Json network = two_faces();
  for (int i = 0; i < 3; ++i) {
    const double turn = 2 * std::numbers::pi * i / 3, lean = std::numbers::pi * i / 3;
    const std::string number = std::to_string(i);
    for (const double side : {-1.0, 1.0}) {
      const double radius = 10 + side * std::cos(lean);
      add_node(network, (side < 0 ? "p" : "q") + number,
               {radius * std::cos(turn), radius * std::sin(turn), side * std::sin(lean)});
    }
    add_line(network, "rung" + number, "p" + number, "q" + number);
  }
  const char* const ends[] = {"p1", "q1", "p2", "q2", "q0", "p0"};
  for (int i = 0; i < 3; ++i) {
    const std::string number = std::to_string(i);
    add_line(network, "low" + number, "p" + number, ends[2 * i]);
    add_line(network, "high" + number, "q" + number, ends[2 * i + 1]);
    const std::string last = i < 2 ? "+rung" + std::to_string(i + 1) : "-rung0";
    add_face(network, "strip" + number, {"+low" + number, last, "-high" + number, "-rung" + number});
  }
  return network;
}

void fold_back(Json& network) {
  element(network, "nodes", "e")["p"] = {2, 1, -0.2};
  element(network, "nodes", "f")["p"] = {0, 1, -0.2};
  curve(network, "ab")["join"] = "smooth";
}

void make_hook(Json& network) {
  const double places[][2] = {{0, -3}, {3, -3}, {3, -2.9}, {0.1, -2.9}, {0.1, -0.1}};
  Json loop{"-ab"};
  std::string before = "a";
  for (int i = 0; i < 5; ++i) {
    const std::string id = "h" + std::to_string(i);
    add_node(network, id, {places[i][0], places[i][1], 0});
    add_line(network, "k" + std::to_string(i), before, id);
    loop.push_back("+k" + std::to_string(i));
    before = id;
  }
  add_line(network, "k5", before, "b");
  loop.push_back("+k5");
  bad_loop(network) = loop;
}

Json point(const std::string& id, const Json& place) { return {{"id", id}, {"face", "bad"}, {"p", place}}; }

std::vector<CodeNetwork> refused_networks() {
  return {{"E_DUP_ID",
           changed([](Json& n) {
             add_node(n, "a", {5, 5, 5});
           }),
           {"a"},
           false,
           3},
          {"E_DUP_CURVE", changed([](Json& n) { bad_loop(n).push_back("+ab"); }), {"bad"}, false, 3},
          {"E_NO_NODE", changed([](Json& n) { curve(n, "ef")["from"] = "z"; }), {"ef"}, false, 3},
          {"E_NO_CURVE", changed([](Json& n) { bad_loop(n)[0] = "+zz"; }), {"bad"}, false, 3},
          {"E_NO_FACE",
           changed([](Json& n) {
             n["points"] = {point("p", {0, 0, 0})};
             n["points"][0]["face"] = "z";
           }),
           {"p"},
           false,
           3},
          {"E_NOT_FINITE",
           changed([](Json& n) {
             element(n, "nodes", "e")["p"] = {"NaN", 0, 0};
           }),
           {"e"},
           false,
           3}};
}

std::vector<CodeNetwork> failing_networks() {
  return {{"E_GAP",
           changed([](Json& n) {
             curve(n, "ef")["ctrl"] = {{2, -1.2, 0.1}, {0, -1, 0}};
           }),
           {"ef"},
           true},
          {"E_OPEN_LOOP", changed([](Json& n) { bad_loop(n)[1] = "+ef"; }), {"bad", "fa", "ef", "be"}, true},
          {"E_TOO_FEW", changed([](Json& n) { bad_loop(n) = {"-ab"}; }), {"bad", "ab"}, true},
          {"E_TOO_MANY", changed([](Json& n) { make_half_circle(n, 70); }), {"bad"}, true},
          {"E_ZERO_LENGTH",
           changed([](Json& n) {
             element(n, "nodes", "e")["p"] = {0, -1, 0};
           }),
           {"ef"},
           true},
          {"E_POINT_CONFLICT",
           changed([](Json& n) {
             n["points"] = {point("p", {1, -0.5, 0.2}), point("q", {1, -0.5, 0.4})};
             for (Json& entry : n["points"]) entry["fan"] = {0, 0.1, 0.1};
           }),
           {"p", "q"}},
          {"E_INNER_OUTSIDE",
           changed([](Json& n) {
             n["curves"].push_back({{"id", "inner"}, {"ctrl", {{1, -0.5, 0}, {1, -2, 0}}}});
             element(n, "faces", "bad")["inner"] = {{{"curve", "inner"}}};
           }),
           {"inner", "bad"}},
          {"E_SLOPE",
           changed([](Json& n) {
             n["slopes"] = {{{"curve", "ef"}, {"at", {0.5}}, {"normal", {{-2, 0, -0.1}}}}};
           }),
           {"ef"}}};
}

std::vector<CodeNetwork> warned_networks() {
  return {{"W_SNAP",
           changed([](Json& n) {
             curve(n, "ef")["ctrl"] = {{2, -1.0005, 0.1}, {0, -1, 0}};
           }),
           {"ef"}},
          {"W_TOO_MANY", changed([](Json& n) { make_half_circle(n, 15); }), {"bad"}},
          {"W_DOMAIN_RELAXED",
           changed([](Json& n) {
             add_node(n, "g", {1, -0.05, 0});
             add_line(n, "ag", "a", "g");
             add_line(n, "gb", "g", "b");
             bad_loop(n) = {"-ab", "+ag", "+gb"};
           }),
           {"bad"}},
          {"W_SMOOTH_CONFLICT", changed(fold_back), {"good", "bad", "a", "b"}},
          {"W_ORIENT", moebius_strip(), {"rung2", "strip1", "strip2"}},
          {"W_NONMANIFOLD",
           changed([](Json& n) {
             curve(n, "ab")["join"] = "smooth";
             add_node(n, "g", {1, 0, 2});
             add_line(n, "ag", "a", "g");
             add_line(n, "gb", "g", "b");
             add_face(n, "fin", {"-ab", "+ag", "+gb"});
           }),
           {"ab", "good", "bad", "fin"}},
          {"W_FOLD", changed(make_hook), {"bad"}},
          {"W_MOVED_INSIDE",
           changed([](Json& n) {
             n["points"] = {point("p", {1, -3, 0})};
           }),
           {"p", "bad"}},
          {"W_POINTS_NEAR",
           changed([](Json& n) {
             n["points"] = {point("p", {1, -0.5, 0.2}), point("q", {1, -0.5, 0.4})};
             n["points"][0]["fan"] = {0, 0.1, 0.1};
             n["points"][1]["fan"] = {0, 0.1, 0.1001};
           }),
           {"p", "q"}},
          {"W_IGNORED", changed([](Json& n) { curve(n, "ef")["colour"] = "red"; }), {"network.json"}}};
}

}  // namespace

Json two_faces() {
  Json network{{"format", "croquis-abs/1"}, {"tolerance", 0.001}};
  add_node(network, "a", {0, 0, 0});
  add_node(network, "b", {2, 0, 0});
  add_node(network, "c", {2, 1, 0.2});
  add_node(network, "d", {0, 1, 0});
  add_node(network, "e", {2, -1, 0.1});
  add_node(network, "f", {0, -1, 0});
  const char* const lines[][3] = {{"ab", "a", "b"}, {"bc", "b", "c"}, {"cd", "c", "d"}, {"da", "d", "a"},
                                  {"be", "b", "e"}, {"ef", "e", "f"}, {"fa", "f", "a"}};
  for (const auto& line : lines) add_line(network, line[0], line[1], line[2]);
  add_face(network, "good", {"+ab", "+bc", "+cd", "+da"});
  add_face(network, "bad", {"-fa", "-ef", "-be", "-ab"});
  return network;
}

std::vector<CodeNetwork> code_networks() {
  std::vector<CodeNetwork> all = refused_networks();
  for (CodeNetwork& network : failing_networks()) all.push_back(std::move(network));
  for (CodeNetwork& network : warned_networks()) all.push_back(std::move(network));
  return all;
}

}  // namespace croquis::test
