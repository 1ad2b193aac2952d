#include "ribbon/linear/fill_order.h"

#include <algorithm>
#include <utility>

namespace ribbon {

void FillOrder::begin(std::size_t count) {
  couplings_.clear();
  neighbours_.assign(count, {});
  elements_.assign(count, {});
  degrees_.assign(count, 0);
  head_.assign(count + 1, -1);
  next_.assign(count, -1);
  last_.assign(count, -1);
  mark_.assign(count, -1);
  uncovered_.assign(count, -1);
  order_.clear();
  order_.reserve(count);
  covered_.clear();
}

void FillOrder::couple(int a, int b) {
  if (a == b) return;
  couplings_.push_back(a);
  couplings_.push_back(b);
}

std::span<const int> FillOrder::find() {
  make_lists();
  for (std::size_t i = neighbours_.size(); i-- > 0;) insert(static_cast<int>(i));
  least_ = 0;
  while (order_.size() < neighbours_.size()) {
    while (head_[at(least_)] < 0) ++least_;
    eliminate(head_[at(least_)]);
  }
  return order_;
}

/// Each variable's neighbours, each of them once.
void FillOrder::make_lists() {
  for (const int i : couplings_) ++neighbours_[at(i)].variables;
  std::size_t first = 0;
  for (Neighbours& own : neighbours_) {
    own.first = first;
    first += at(own.variables);
    own.variables = 0;
  }
  adjacent_.resize(first);
  for (std::size_t k = 0; k < couplings_.size(); k += 2) {
    const int a = couplings_[k];
    const int b = couplings_[k + 1];
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      Neighbours& own = neighbours_[at(from)];
      adjacent_[own.first + at(own.variables++)] = to;
    }
  }
  for (std::size_t i = 0; i < neighbours_.size(); ++i) {
    const std::span<int> all = variables(static_cast<int>(i));
    std::sort(all.begin(), all.end());
    neighbours_[i].variables = static_cast<int>(std::unique(all.begin(), all.end()) - all.begin());
    degrees_[i] = neighbours_[i].variables;
  }
}

void FillOrder::eliminate(int pivot) {
  remove(pivot);
  order_.push_back(pivot);
  cover(pivot);
  count_uncovered(pivot);
  for (std::size_t k = 0; k < at(elements_[at(pivot)].count); ++k) update(covered(pivot)[k], pivot);
}

/// The pivot's element: all that it was coupled with, by itself or by elements, which it absorbs.
void FillOrder::cover(int pivot) {
  const std::size_t first = covered_.size();
  mark_[at(pivot)] = pivot;
  const auto take = [&](int variable) {
    if (degrees_[at(variable)] < 0 || mark_[at(variable)] == pivot) return;
    mark_[at(variable)] = pivot;
    covered_.push_back(variable);
  };
  degrees_[at(pivot)] = -1;  // eliminated
  for (const int variable : variables(pivot)) take(variable);
  for (const int element : elements(pivot)) {
    for (std::size_t k = 0; k < at(elements_[at(element)].count); ++k) take(covered(element)[k]);
    elements_[at(element)].absorbed = true;
  }
  elements_[at(pivot)] = {first, static_cast<int>(covered_.size() - first), false};
}

/// Of each element that shares variables with the pivot's, how many it does not share.
void FillOrder::count_uncovered(int pivot) {
  for (const int variable : covered(pivot)) {
    for (const int element : elements(variable)) uncovered_[at(element)] = -1;
  }
  for (const int variable : covered(pivot)) {
    for (const int element : elements(variable)) {
      if (elements_[at(element)].absorbed) continue;
      int& left = uncovered_[at(element)];
      if (left < 0) {
        const std::span<int> all = covered(element);
        left = static_cast<int>(
            std::count_if(all.begin(), all.end(), [this](int other) { return degrees_[at(other)] >= 0; }));
      }
      --left;
    }
  }
}

/// The neighbours of a variable that the pivot covers, and a bound of its degree.
void FillOrder::update(int variable, int pivot) {
  Neighbours& own = neighbours_[at(variable)];
  const int shared = elements_[at(pivot)].count - 1;
  int degree = shared;
  const std::span<int> all(adjacent_.data() + own.first, at(own.elements + own.variables));
  const std::size_t elements_before = at(own.elements);
  std::size_t kept = 0;
  for (std::size_t k = 0; k < elements_before; ++k) {
    const int element = all[k];
    if (elements_[at(element)].absorbed) continue;
    if (uncovered_[at(element)] == 0) continue;  // the pivot's covers it
    degree += uncovered_[at(element)];
    all[kept++] = element;
  }
  // There is room for one more element: the pivot was among the variables, or one that it has absorbed among these.
  const std::size_t elements_kept = kept;
  std::size_t variables_kept = 0;
  for (std::size_t k = elements_before; k < all.size(); ++k) {
    const int other = all[k];
    if (degrees_[at(other)] < 0 || mark_[at(other)] == pivot) continue;
    all[kept++] = other;
    ++variables_kept;
  }
  if (variables_kept > 0) all[kept] = all[elements_kept];
  all[elements_kept] = pivot;
  own.elements = static_cast<int>(elements_kept) + 1;
  own.variables = static_cast<int>(variables_kept);
  degree += own.variables;
  const int left = static_cast<int>(neighbours_.size() - order_.size()) - 1;
  remove(variable);
  degrees_[at(variable)] = std::min({left, degrees_[at(variable)] + shared, degree});
  insert(variable);
}

void FillOrder::insert(int variable) {
  const int degree = degrees_[at(variable)];
  next_[at(variable)] = head_[at(degree)];
  last_[at(variable)] = -1;
  if (head_[at(degree)] >= 0) last_[at(head_[at(degree)])] = variable;
  head_[at(degree)] = variable;
  least_ = std::min(least_, degree);
}

void FillOrder::remove(int variable) {
  const int next = next_[at(variable)];
  const int last = last_[at(variable)];
  if (next >= 0) last_[at(next)] = last;
  (last >= 0 ? next_[at(last)] : head_[at(degrees_[at(variable)])]) = next;
}

std::span<int> FillOrder::elements(int variable) {
  return {adjacent_.data() + neighbours_[at(variable)].first, at(neighbours_[at(variable)].elements)};
}

std::span<int> FillOrder::variables(int variable) {
  const Neighbours& own = neighbours_[at(variable)];
  return {adjacent_.data() + own.first + own.elements, at(own.variables)};
}

std::span<int> FillOrder::covered(int element) {
  return {covered_.data() + elements_[at(element)].first, at(elements_[at(element)].count)};
}

}  // namespace ribbon
