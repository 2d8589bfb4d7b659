// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/export/export.h"
#include "report/export/shapes.h"
#include "report/figures.h"
#include "report/page.h"
#include "report/text.h"
#include "support/utc.h"

#include <fmt/format.h>

#include <cmath>

namespace glider::report {
namespace {

/// "2009-08-11T14:13:20Z".
std::string stamp(double utc_s) {
  std::string text = support::utcText(utc_s);
  const size_t space = text.find(' ');
  return space == std::string::npos ? text : text.replace(space, 1, "T") + "Z";
}

std::string coordinatesOf(const std::vector<MapPoint>& points) {
  std::string out;
  for (const MapPoint& point : points) {
    out += fmt::format("{}{:.7f},{:.7f}", out.empty() ? "" : " ", point.longitude_deg,
                       point.latitude_deg);
  }
  return out;
}

/// A name as text of XML, which has no control characters even when they are escaped.
std::string named(const std::string& name) {
  return fmt::format("<name>{}</name>", escapeHtml(plain(name)));
}

std::string placemark(const std::string& name, const std::string& style, const std::string& time,
                      const std::string& geometry) {
  return fmt::format("<Placemark>{}{}<styleUrl>#{}</styleUrl>{}</Placemark>\n", named(name), time,
                     style, geometry);
}

std::string geometryOf(const MapLine& line) {
  std::string parts;
  for (const auto& part : line.parts) {
    parts += fmt::format(
        "<LineString><tessellate>1</tessellate><coordinates>{}</coordinates></LineString>",
        coordinatesOf(part));
  }
  return line.parts.size() == 1 ? parts : fmt::format("<MultiGeometry>{}</MultiGeometry>", parts);
}

std::string spanOf(const MapLine& line, double start_utc_s) {
  return fmt::format("<TimeSpan><begin>{}</begin><end>{}</end></TimeSpan>",
                     stamp(start_utc_s + line.parts.front().front().time_s),
                     stamp(start_utc_s + line.parts.back().back().time_s));
}

// Colours are of alpha, blue, green, red.
constexpr const char* kStyles =
    "<Style id=\"true\"><LineStyle><color>ffb27200</color><width>3</width></LineStyle></Style>\n"
    "<Style "
    "id=\"estimate\"><LineStyle><color>c084786b</color><width>2</width></LineStyle></Style>\n"
    "<Style id=\"mark\"><IconStyle><scale>0.8</scale></IconStyle></Style>\n"
    "<Style id=\"watch\"><LineStyle><color>ff005cb3</color></LineStyle>"
    "<PolyStyle><fill>0</fill></PolyStyle></Style>\n";

}  // namespace

std::string flightToKml(const support::Trace& trace) {
  const MapShapes shapes = shapesOf(trace);
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n";
  out += named(flightTitle(trace)) + "\n" + kStyles;
  for (const MapLine& line : shapes.lines) {
    const char* style = &line == &shapes.lines.front() ? "true" : "estimate";
    out += placemark(line.name, style, spanOf(line, trace.start_utc_s), geometryOf(line));
  }
  for (const MapMark& mark : shapes.marks) {
    const std::string time = std::isfinite(mark.at.time_s)
                                 ? fmt::format("<TimeStamp><when>{}</when></TimeStamp>",
                                               stamp(trace.start_utc_s + mark.at.time_s))
                                 : "";
    out += placemark(
        mark.name, "mark", time,
        fmt::format("<Point><coordinates>{}</coordinates></Point>", coordinatesOf({mark.at})));
  }
  for (const MapRing& ring : shapes.rings) {
    out += placemark(ring.name, "watch", "",
                     fmt::format("<Polygon><outerBoundaryIs><LinearRing><coordinates>{}"
                                 "</coordinates></LinearRing></outerBoundaryIs></Polygon>",
                                 coordinatesOf(ring.points)));
  }
  return out + "</Document>\n</kml>\n";
}

}  // namespace glider::report
