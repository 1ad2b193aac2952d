#include "ribbon/linear/fill_order.h"

#include <algorithm>
#include <utility>

#include "ribbon/linear/index.h"

namespace ribbon {

void FillOrder::begin(std::size_t count) {
  couplings_.clear();
  neighbours_.assign(count, {});
  elements_.assign(count, {});
  degrees_.assign(count, 0);
  head_.assign(count + 1, -1);
  next_.assign(count, -1);
  previous_.assign(count, -1);
  mark_.assign(count, -1);
  outside_.assign(count, -1);
  order_.clear();
  order_.reserve(count);
  element_variables_.clear();
}

void FillOrder::couple(int a, int b) {
  if (a == b) return;
  couplings_.push_back(a);
  couplings_.push_back(b);
}

std::span<const int> FillOrder::find() {
  make_neighbour_lists();
  for (std::size_t i = neighbours_.size(); i-- > 0;) insert_by_degree(static_cast<int>(i));
  min_degree_ = 0;
  while (order_.size() < neighbours_.size()) {
    while (head_[at(min_degree_)] < 0) ++min_degree_;
    eliminate(head_[at(min_degree_)]);
  }
  return order_;
}

/// Lists the neighbours of each variable, each neighbour once.
void FillOrder::make_neighbour_lists() {
  for (const int i : couplings_) ++neighbours_[at(i)].variables;
  std::size_t first = 0;
  for (Neighbours& own : neighbours_) {
    own.first = first;
    first += at(own.variables);
    own.variables = 0;
  }
  neighbour_lists_.resize(first);
  for (std::size_t k = 0; k < couplings_.size(); k += 2) {
    const int a = couplings_[k];
    const int b = couplings_[k + 1];
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, a}}) {
      Neighbours& own = neighbours_[at(from)];
      neighbour_lists_[own.first + at(own.variables++)] = to;
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
  remove_by_degree(pivot);
  order_.push_back(pivot);
  make_element(pivot);
  count_outside_variables(pivot);
  for (std::size_t k = 0; k < at(elements_[at(pivot)].count); ++k) update_degree(variables_of(pivot)[k], pivot);
}

/// Makes the element of the pivot: all remaining variables that it was coupled with, directly or by an element. It
/// absorbs these elements.
void FillOrder::make_element(int pivot) {
  const std::size_t first = element_variables_.size();
  mark_[at(pivot)] = pivot;
  const auto add = [&](int variable) {
    if (degrees_[at(variable)] < 0 || mark_[at(variable)] == pivot) return;
    mark_[at(variable)] = pivot;
    element_variables_.push_back(variable);
  };
  degrees_[at(pivot)] = -1;  // eliminated
  for (const int variable : variables(pivot)) add(variable);
  for (const int element : elements(pivot)) {
    for (std::size_t k = 0; k < at(elements_[at(element)].count); ++k) add(variables_of(element)[k]);
    elements_[at(element)].absorbed = true;
  }
  elements_[at(pivot)] = {first, static_cast<int>(element_variables_.size() - first), false};
}

/// Counts the variables outside the pivot's element for each element that shares a variable with it. All variables of
/// an element that is not absorbed remain: the element of one that was eliminated would have absorbed it.
void FillOrder::count_outside_variables(int pivot) {
  for (const int variable : variables_of(pivot)) {
    for (const int element : elements(variable)) outside_[at(element)] = -1;
  }
  for (const int variable : variables_of(pivot)) {
    for (const int element : elements(variable)) {
      if (elements_[at(element)].absorbed) continue;
      int& left = outside_[at(element)];
      if (left < 0) left = elements_[at(element)].count;
      --left;
    }
  }
}

/// Removes from the neighbours of a variable what the pivot's element contains, and adds that element. Returns how many
/// neighbours the variable may have outside it.
int FillOrder::filter_neighbours(int variable, int pivot) {
  Neighbours& own = neighbours_[at(variable)];
  int outside = 0;
  const std::span<int> all(neighbour_lists_.data() + own.first, at(own.elements + own.variables));
  const std::size_t old_element_count = at(own.elements);
  std::size_t count = 0;
  for (std::size_t k = 0; k < old_element_count; ++k) {
    const int element = all[k];
    if (elements_[at(element)].absorbed) continue;
    if (outside_[at(element)] == 0) continue;  // the pivot's element contains it
    outside += outside_[at(element)];
    all[count++] = element;
  }
  // One entry is free for the new element: the list had the pivot, or an element that it absorbed.
  const std::size_t element_count = count;
  std::size_t variable_count = 0;
  for (std::size_t k = old_element_count; k < all.size(); ++k) {
    const int other = all[k];
    if (degrees_[at(other)] < 0 || mark_[at(other)] == pivot) continue;
    all[count++] = other;
    ++variable_count;
  }
  if (variable_count > 0) all[count] = all[element_count];
  all[element_count] = pivot;
  own.elements = static_cast<int>(element_count) + 1;
  own.variables = static_cast<int>(variable_count);
  return outside + own.variables;
}

/// Updates the neighbours of a variable in the pivot's element, and the upper bound of its degree: the least of the
/// number of remaining variables, the old bound plus the new element, and a bound of the union of its elements.
void FillOrder::update_degree(int variable, int pivot) {
  const int shared = elements_[at(pivot)].count - 1;
  const int degree = shared + filter_neighbours(variable, pivot);
  const int left = static_cast<int>(neighbours_.size() - order_.size()) - 1;
  remove_by_degree(variable);
  degrees_[at(variable)] = std::min({left, degrees_[at(variable)] + shared, degree});
  insert_by_degree(variable);
}

void FillOrder::insert_by_degree(int variable) {
  const int degree = degrees_[at(variable)];
  next_[at(variable)] = head_[at(degree)];
  previous_[at(variable)] = -1;
  if (head_[at(degree)] >= 0) previous_[at(head_[at(degree)])] = variable;
  head_[at(degree)] = variable;
  min_degree_ = std::min(min_degree_, degree);
}

void FillOrder::remove_by_degree(int variable) {
  const int next = next_[at(variable)];
  const int previous = previous_[at(variable)];
  if (next >= 0) previous_[at(next)] = previous;
  (previous >= 0 ? next_[at(previous)] : head_[at(degrees_[at(variable)])]) = next;
}

std::span<int> FillOrder::elements(int variable) {
  return {neighbour_lists_.data() + neighbours_[at(variable)].first, at(neighbours_[at(variable)].elements)};
}

std::span<int> FillOrder::variables(int variable) {
  const Neighbours& own = neighbours_[at(variable)];
  return {neighbour_lists_.data() + own.first + own.elements, at(own.variables)};
}

std::span<int> FillOrder::variables_of(int element) {
  return {element_variables_.data() + elements_[at(element)].first, at(elements_[at(element)].count)};
}

}  // namespace ribbon
