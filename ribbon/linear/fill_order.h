#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ribbon {

/// Finds an order of elimination with little fill-in for a sparse symmetric matrix: the approximate minimum degree
/// order (Amestoy, Davis & Duff 1996). Eliminating a variable makes an element: the set of the remaining variables that
/// it was coupled with, which are all coupled from then on. An element absorbs the elements that it contains, so the
/// fill-in is never stored. It allocates memory only for a larger graph than ever before.
class FillOrder {
 public:
  /// Starts a graph of `count` variables without couplings.
  void begin(std::size_t count);
  /// Couples the variables a and b. Repeated couplings count once.
  void couple(int a, int b);
  /// Returns all variables in the order of elimination. Among variables of equal degree, the one whose degree changed
  /// last comes first, and initially the one of the lowest index. The same graph gives the same order.
  std::span<const int> find();

 private:
  /// Neighbours of a variable in neighbour_lists_: first the elements that contain it, then variables.
  struct Neighbours {
    std::size_t first = 0;
    int elements = 0;   // how many
    int variables = 0;  // how many
  };
  struct Element {
    std::size_t first = 0;  // in element_variables_
    int count = 0;          // of its variables
    bool absorbed = false;
  };
  void make_neighbour_lists();
  void eliminate(int pivot);
  void make_element(int pivot);
  void count_outside_variables(int pivot);
  int filter_neighbours(int variable, int pivot);
  void update_degree(int variable, int pivot);
  void insert_by_degree(int variable);
  void remove_by_degree(int variable);
  std::span<int> elements(int variable);
  std::span<int> variables(int variable);
  std::span<int> variables_of(int element);

  std::vector<int> couplings_;  // pairs
  std::vector<Neighbours> neighbours_;
  std::vector<int> neighbour_lists_;
  std::vector<Element> elements_;  // by the eliminated variable
  std::vector<int> element_variables_;
  std::vector<int> degrees_;                 // upper bound, by variable; −1: eliminated
  std::vector<int> head_, next_, previous_;  // lists of variables of equal degree
  std::vector<int> mark_;                    // by variable: the last pivot whose element contains it
  std::vector<int> outside_;                 // by element: number of its variables outside the pivot's element
  std::vector<int> order_;
  int min_degree_ = 0;  // lower bound of the degrees
};

}  // namespace ribbon
