#include "tests/study/page.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

namespace study {
namespace {

using Json = nlohmann::ordered_json;

/// Returns JSON that may stand in a script element.
std::string in_script(const std::string& json) {
  std::string safe;
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(); }

std::string data_of(const Report& report) {
  Json json{{"axis", report.axis}, {"points", Json::array()}};
  const std::vector<std::size_t> on_front = front(report.points);
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    json["points"].push_back({{"method", p.method},
                              {"setting", p.setting},
                              {"group", p.group},
                              {"cost", p.cost_us},
                              {"p99", p.p99_us},
                              {"error", number_or_null(p.error_m)},
                              {"failure", p.failure},
                              {"compared", !p.not_compared},
                              {"front", std::find(on_front.begin(), on_front.end(), k) != on_front.end()}});
  }
  json["recommended"] = report.recommended ? Json(*report.recommended) : Json();
  json["recommendedWith"] = report.recommended_with;
  json["present"] = report.present ? Json(*report.present) : Json();
  json["films"] = report.films.empty() ? Json() : Json::parse(report.films);
  return in_script(json.dump());
}

void add_failures(std::ostringstream& out, const Report& report) {
  std::ostringstream lines;
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    if (p.failure.empty()) continue;
    lines << "<li><span class=\"bad\">failed</span> " << escaped(p.method + " " + p.setting) << ": "
          << escaped(p.failure) << " <button class=\"show\" data-point=\"" << k << "\" hidden>show</button>\n";
  }
  if (lines.str().empty()) return;
  out << "<h2>What failed, and when</h2>\n<ul>\n" << lines.str() << "</ul>\n";
}

}  // namespace

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '&') {
      safe += "&amp;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string page_of(const Report& report, const std::string& method) {
  std::ostringstream out;
  out << "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" "
         "href=\"data:,\">\n"
         "<title>"
      << escaped(report.title) << ": error against cost</title>\n<style>\n"
      << page_style << "</style>\n<h1>" << escaped(report.title) << ": error against cost</h1>\n";
  if (!report.headline.empty()) out << "<p id=\"headline\">" << escaped(report.headline) << "</p>\n";
  out << "<div id=\"first\">\n<div id=\"plots\"></div>\n<div id=\"beside\">\n<p id=\"about\" "
         "aria-live=\"polite\"></p>\n"
         "<div id=\"film\" hidden>\n<canvas id=\"canvas\" role=\"img\" aria-label=\"The converged run and the setting, "
         "over each other\"></canvas>\n<p id=\"controls\"><button id=\"play\">pause</button> <button "
         "id=\"worst\">greatest error</button> <input id=\"seek\" type=\"range\" min=\"0\" value=\"0\" "
         "aria-label=\"time\"> <span id=\"time\"></span></p>\n</div>\n</div>\n</div>\n";
  if (!report.findings.empty()) {
    out << "<h2>Terms of the cords</h2>\n<ul>\n";
    for (const std::string& line : report.findings) out << "<li>" << escaped(line) << "\n";
    out << "</ul>\n";
  }
  add_failures(out, report);
  out << "<details><summary>Method, definitions and all numbers</summary>\n"
      << method << "</details>\n"
      << "<script type=\"application/json\" id=\"data\">" << data_of(report) << "</script>\n<script>\n"
      << page_script << "</script>\n</html>\n";
  return out.str();
}

}  // namespace study
