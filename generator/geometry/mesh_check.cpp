#include "geometry/mesh_check.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "geometry/topology.h"

namespace collage {
namespace {

std::size_t count_forward(std::span<const EdgeUse> edge) {
  return static_cast<std::size_t>(
      std::count_if(edge.begin(), edge.end(), [](const EdgeUse& use) { return use.forward; }));
}

void check_edges(const Topology& topology, MeshReport& report) {
  report.closed = topology.edge_count() > 0;
  report.boundary_edges = topology.boundary_edge_count();
  for (std::size_t i = 0; i < topology.edge_count(); ++i) {
    const auto edge = topology.edge(i);
    report.nonmanifold_edges += edge.size() > 2 ? 1 : 0;
    report.closed = report.closed && edge.size() % 2 == 0;
    if (edge.size() > 1 && 2 * count_forward(edge) != edge.size()) {
      ++report.inconsistent_edges;
    }
  }
}

std::size_t count_parts(const Mesh& mesh, const Topology& topology) {
  DisjointSets parts(mesh.triangles.size());
  for (std::size_t i = 0; i < topology.edge_count(); ++i) {
    for (const EdgeUse& use : topology.edge(i)) {
      parts.unite(topology.edge(i)[0].triangle, use.triangle);
    }
  }
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const bool has_edges = !has_two_equal(welded_triangle(mesh, topology, t));
    count += has_edges && parts.find(t) == t ? 1 : 0;
  }
  return count;
}

std::size_t count_vertices(const Mesh& mesh, const Topology& topology) {
  std::vector<char> used(mesh.positions.size(), 0);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const uvec3 corners = welded_triangle(mesh, topology, t);
    used[corners.x] = used[corners.y] = used[corners.z] = 1;
  }
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
}

std::size_t count_degenerate(const Mesh& mesh) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const dvec3 a = mesh.corner(t, 0);
    count += glm::cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a) == dvec3(0.0) ? 1 : 0;
  }
  return count;
}

/// "3 parts", "1 part".
std::string counted(std::size_t count, std::string_view thing) {
  return grouped(count) + " " + std::string(thing) + (count == 1 ? "" : "s");
}

}  // namespace

MeshReport check_mesh(const Mesh& mesh) {
  const Topology topology(mesh);
  MeshReport report;
  report.triangles = mesh.triangles.size();
  report.vertices = count_vertices(mesh, topology);
  report.parts = count_parts(mesh, topology);
  report.degenerate_triangles = count_degenerate(mesh);
  check_edges(topology, report);
  report.volume = enclosed_volume(mesh);
  report.area = surface_area(mesh);
  report.box = bounding_box(mesh);
  return report;
}

std::string text_of(const MeshReport& report) {
  std::string text = counted(report.triangles, "triangle") + " in " +
                     counted(report.parts, "part") + (report.closed ? ", closed" : ", open");
  if (report.closed && report.inconsistent_edges == 0) {
    text += fmt::format(", volume {:.3g}", report.volume);
  }
  for (const auto& [count, thing] :
       {std::pair{report.boundary_edges, "boundary edge"},
        std::pair{report.nonmanifold_edges, "non-manifold edge"},
        std::pair{report.inconsistent_edges, "inconsistently oriented edge"},
        std::pair{report.degenerate_triangles, "degenerate triangle"}}) {
    if (count > 0) {
      text += ", " + counted(count, thing);
    }
  }
  const dvec3 size = report.box.extent();
  return text + fmt::format(", {:.3g} x {:.3g} x {:.3g}", size.x, size.y, size.z);
}

std::string text_of(const Orientation& orientation) {
  std::vector<std::string> parts;
  if (orientation.turned_sheets > 0) {
    parts.push_back(fmt::format("turned {} of {} outside out", grouped(orientation.turned_sheets),
                                counted(orientation.sheets, "part")));
  }
  if (orientation.mended_triangles > 0) {
    parts.push_back("turned " + counted(orientation.mended_triangles, "triangle") +
                    " to agree with the rest");
  }
  if (orientation.one_sided_sheets > 0) {
    parts.push_back(counted(orientation.one_sided_sheets, "part") + " with one side only");
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

}  // namespace collage
