#include "geometry/frames.h"

namespace collage {
namespace {

dvec3 reflect(const dvec3& vector, const dvec3& across) {
  return vector - 2.0 * glm::dot(across, vector) / glm::dot(across, across) * across;
}

Frame frame(const CurvePoint& point, const dvec3& u) {
  return {point.position, point.along, u, glm::cross(point.along, u)};
}

}  // namespace

std::vector<Frame> frames_along(std::span<const CurvePoint> curve, const dvec3& up) {
  const dvec3& start = curve[0].along;
  std::vector<Frame> frames = {frame(curve[0], glm::normalize(up - glm::dot(up, start) * start))};
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Frame& last = frames.back();
    const dvec3 step = curve[i].position - last.origin;
    const dvec3 turned_along = reflect(last.along, step);
    const dvec3 turned_u = reflect(last.u, step);
    const dvec3 rest = curve[i].along - turned_along;
    const bool is_there = glm::dot(rest, rest) < 1e-24;
    const dvec3 u = is_there ? turned_u : reflect(turned_u, rest);
    frames.push_back(frame(curve[i], u));
  }
  return frames;
}

std::vector<CurvePoint> bezier_curve(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d,
                                     int steps) {
  std::vector<CurvePoint> curve;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const double s = 1.0 - t;
    curve.push_back({s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d,
                     glm::normalize(s * s * (b - a) + 2.0 * s * t * (c - b) + t * t * (d - c))});
  }
  return curve;
}

}  // namespace collage
