#include "tests/study/setting.h"

#include "tests/study/text.h"

namespace study {

Setting present() { return {"direct", "own", 0, 0.0}; }

bool is_present(const Setting& setting) { return setting == present(); }

std::string name_of(const Setting& setting) {
  if (is_present(setting)) return "as in the level";
  std::string name = "substeps=" + std::to_string(setting.substeps);
  if (is_box2d(setting)) {
    name += " iterations=" + std::to_string(setting.iterations) + "/" + std::to_string(3 * setting.iterations / 8);
  } else if (setting.solver != "thesis") {
    name = setting.integrator + " " + name + " tolerance=" + significant(setting.tolerance, 6);
  }
  if (!is_box2d(setting) && setting.iterations != 0) name += " iterations=" + std::to_string(setting.iterations);
  if (setting.max_work != 0) name += " max_work=" + std::to_string(setting.max_work);
  if (setting.rows != 1) name += " rows=" + std::to_string(setting.rows);
  if (setting.points != 1.0) name += " points=x" + significant(setting.points, 6);
  return name;
}

ribbon::Accuracy accuracy_of(const Setting& setting) {
  ribbon::Accuracy accuracy;
  if (setting.integrator == "implicit_euler") accuracy.integrator = ribbon::Integrator::implicit_euler;
  accuracy.soft_contacts = accuracy.integrator == ribbon::Integrator::implicit_euler;
  accuracy.substeps = setting.substeps;
  accuracy.tolerance = setting.tolerance;
  if (setting.iterations > 0) accuracy.max_iterations = setting.iterations;
  if (setting.max_work > 0) accuracy.max_work = setting.max_work;
  return accuracy;
}

Mesh mesh_of(const Setting& setting) { return {setting.points, setting.rows}; }

bool is_box2d(const Setting& setting) { return setting.solver.starts_with("box2d"); }

std::vector<Setting> grid(bool quick) {
  std::vector<Setting> all = {present(), {"direct", "implicit_euler", 1, 1e-2}, {}, {"direct", "tr_bdf2", 4, 1e-4}};
  const auto add = [&all](const Setting& setting) {
    for (const Setting& known : all) {
      if (known == setting) return;
    }
    all.push_back(setting);
  };
  const std::vector<int> substeps = quick ? std::vector{1, 4} : std::vector{1, 2, 4, 8};
  const std::vector<double> tolerances = quick ? std::vector{5e-4} : std::vector{1e-2, 5e-4, 1e-5};
  for (const char* integrator : {"tr_bdf2", "implicit_euler"}) {
    for (const int n : substeps) {
      for (const double tolerance : tolerances) add({"direct", integrator, n, tolerance});
    }
  }
  if (!quick) {
    for (const double points : {0.5, 2.0}) {
      for (const int n : {1, 4}) add({"direct", "tr_bdf2", n, 5e-4, points});
    }
    for (const int iterations : {2, 32}) {
      for (const double tolerance : {5e-4, 1e-5}) add({"direct", "tr_bdf2", 1, tolerance, 1.0, iterations});
    }
    for (const int rows : {2, 3}) {
      for (const int n : {1, 4}) add({"direct", "tr_bdf2", n, 5e-4, 1.0, 0, rows});
    }
  }
  for (const int n : quick ? std::vector{8} : std::vector{4, 16, 64}) add({"thesis", "", n, 0.0});
  const auto add_chain = [&add](const char* solver, int n, int iterations) {
    add({solver, "", n, 0.0, 1.0, iterations});
  };
  for (const int n : quick ? std::vector{1, 16} : std::vector{1, 4, 16, 64}) add_chain("box2d_chain", n, 8);
  if (quick) return all;
  add_chain("box2d_chain", 1, 128);
  add_chain("box2d_chain", 4, 32);
  for (const int n : {1, 4, 16}) add_chain("box2d_max_distance", n, 8);
  return all;
}

std::vector<Setting> own_settings() {
  std::vector<Setting> own = grid(true);
  std::erase_if(own, [](const Setting& setting) {
    return setting.solver != "direct" || mesh_of(setting) != Mesh{} || is_present(setting);
  });
  return own;
}

Setting with_ample_work(Setting setting) {
  if (setting.solver == "direct" && !is_present(setting) && setting.max_work == 0) setting.max_work = ample_work;
  return setting;
}

Setting probe(const Mesh& mesh) { return {"direct", "tr_bdf2", 4, 1e-5, mesh.points, 0, mesh.rows, unlimited_work}; }

Setting reference(const Mesh& mesh, bool second, bool quick) {
  const int substeps = (second ? 128 : 64) / (quick || mesh.rows > 1 ? 2 : 1);
  return {"direct", "tr_bdf2", substeps, 1e-7, mesh.points, 0, mesh.rows, unlimited_work};
}

}  // namespace study
