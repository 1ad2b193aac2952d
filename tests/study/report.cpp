#include "tests/study/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "tests/study/page.h"
#include "tests/study/plot.h"
#include "tests/study/text.h"

namespace study {
namespace {

constexpr const char* gnuplot_hint =
    "the package is gnuplot-nox, game/setup tests installs it. All numbers are written";

void write(const std::string& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  out.flush();
  if (!out) throw std::runtime_error("cannot write " + path + "; accepted is a folder that can be written (--out)");
}

bool is_shown(const Point& point) { return point.failure.empty() && std::isfinite(point.error_m); }

std::string csv_of(const Report& report) {
  std::ostringstream out;
  out << "method,setting,cost_us,p99_us,error_m,failure,group";
  for (const std::string& column : report.columns) out << ',' << column;
  out << '\n';
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    out << csv_cell(p.method) << ',' << csv_cell(p.setting) << ',' << four_digits(p.cost_us) << ','
        << four_digits(p.p99_us) << ',' << (is_shown(p) ? four_digits(p.error_m) : "") << ',' << csv_cell(p.failure)
        << ',' << csv_cell(p.group);
    if (k < report.cells.size()) {
      for (const std::string& cell : report.cells[k]) out << ',' << csv_cell(cell);
    }
    out << '\n';
  }
  return out.str();
}

std::string json_of(const Report& report) {
  nlohmann::ordered_json json{{"title", report.title}, {"notes", report.notes}};
  const std::vector<std::size_t> on_front = front(report.points);
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    nlohmann::ordered_json entry{
        {"group", p.group}, {"method", p.method}, {"setting", p.setting}, {"cost_us", p.cost_us}, {"p99_us", p.p99_us}};
    entry["error_m"] = is_shown(p) ? nlohmann::ordered_json(p.error_m) : nlohmann::ordered_json();
    entry["failure"] = p.failure;
    entry["front"] = std::find(on_front.begin(), on_front.end(), k) != on_front.end();
    for (std::size_t c = 0; c < report.columns.size() && k < report.cells.size(); ++c) {
      entry[report.columns[c]] = report.cells[k][c];
    }
    json["points"].push_back(entry);
  }
  return json.dump(1) + "\n";
}

std::string head_of(const std::string& title) {
  return "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
         "content=\"width=device-width, initial-scale=1\">\n<title>" +
         escaped(title) + "</title>\n<style>" + page_style + "</style>\n<h1>" + escaped(title) + "</h1>\n";
}

/// Returns true also if there is nothing to draw.
bool plot(const std::string& folder, const std::vector<Point>& points, const std::string& axis) {
  if (std::none_of(points.begin(), points.end(), is_shown)) return true;
  write(folder + "/front.gp", plot_of(points, axis, "front"));
  return draw(folder, "front");
}

void add_rows(std::ostringstream& out, const Report& report, const std::string& group) {
  const std::vector<std::size_t> on_front = front(report.points);
  for (std::size_t k = 0; k < report.points.size(); ++k) {
    const Point& p = report.points[k];
    if (p.group != group) continue;
    const bool best = std::find(on_front.begin(), on_front.end(), k) != on_front.end();
    out << (best          ? "<tr class=\"front\">"
            : is_shown(p) ? "<tr>"
                          : "<tr class=\"failed\">")
        << "<td>" << escaped(p.method) << "<td>" << escaped(p.setting) << "<td>" << four_digits(p.cost_us) << "<td>"
        << four_digits(p.p99_us) << "<td>"
        << (is_shown(p) ? four_digits(p.error_m) : escaped(p.failure.empty() ? "no number" : p.failure));
    if (k < report.cells.size()) {
      for (const std::string& cell : report.cells[k]) out << "<td>" << escaped(cell);
    }
    out << "\n";
  }
}

/// The notes and the table.
std::string method_of(const Report& report) {
  std::ostringstream out;
  for (const std::string& note : report.notes) out << "<p>" << escaped(note) << "</p>\n";
  out << "<p>Bold: no other setting is both cheaper and more exact.</p>\n<div class=\"wide\">\n<table>\n"
         "<tr><th>method<th>setting<th>µs a tick<th>99th percentile<th>"
      << escaped(report.axis);
  for (const std::string& column : report.columns) out << "<th>" << escaped(column);
  out << "\n";
  for (const std::string& group : groups_of(report.points)) {
    if (!group.empty()) out << "<tr><th colspan=\"" << 5 + report.columns.size() << "\">" << escaped(group) << "\n";
    add_rows(out, report, group);
  }
  out << "</table>\n</div>\n";
  return out.str();
}

}  // namespace

void require_folder(const std::string& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  const std::string probe = folder + "/.tradeoff_can_write";
  write(probe, "");
  std::filesystem::remove(probe, ignored);
}

void write_report(const Report& report, const std::string& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  write(folder + "/points.csv", csv_of(report));
  write(folder + "/points.json", json_of(report));
  write(folder + "/index.html", page_of(report, method_of(report)));
  if (!plot(folder, report.points, report.axis)) {
    throw PlotError("gnuplot did not draw the plot of " + folder + " (see gnuplot.log there); " + gnuplot_hint);
  }
}

int write_pages(const std::vector<Page>& pages, const std::function<void(const std::vector<std::string>& done)>& add) {
  std::vector<std::string> done;
  std::string not_drawn;
  int status = 0;
  for (const Page& page : pages) {
    try {
      status = page.write();
    } catch (const PlotError&) {
      not_drawn += (not_drawn.empty() ? "" : ", ") + page.name;
    }
    if (status != 0) break;
    done.push_back(page.name);
    add(done);
  }
  if (not_drawn.empty()) return status;
  std::fprintf(stderr, "tradeoff: gnuplot did not draw the plots of %s (see gnuplot.log in their folders); %s\n",
               not_drawn.c_str(), gnuplot_hint);
  return 1;
}

void write_contents(const std::string& title, const std::vector<std::string>& notes,
                    const std::vector<std::string>& folders, const std::string& folder) {
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  std::ostringstream out;
  out << head_of(title);
  for (const std::string& note : notes) out << "<p>" << escaped(note) << "</p>\n";
  for (const std::string& name : folders) {
    out << "<h2><a href=\"" << name << "/index.html\">" << escaped(name) << "</a></h2>\n<p><a href=\"" << name
        << "/index.html\"><img src=\"" << name << "/front.svg\" alt=\"Error against cost\"></a></p>\n";
  }
  out << "</html>\n";
  write(folder + "/index.html", out.str());
}

}  // namespace study
