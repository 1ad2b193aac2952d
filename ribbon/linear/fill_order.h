#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ribbon {

/// An order in which elimination of a sparse symmetric matrix fills little: of approximate minimum degree (Amestoy,
/// Davis & Duff 1996). What is eliminated is an element, whose variables are coupled with each other; elements that
/// another one covers are absorbed by it, so that what is filled is never stored. Once it has been as large as it gets,
/// it takes no memory, as a library's would in every step.
class FillOrder {
 public:
  /// Begins a graph of so many variables that are not coupled.
  void begin(std::size_t count);
  /// Couples two of them, either way round, and as often as one likes.
  void couple(int a, int b);
  /// All variables in the order in which they are to be eliminated. Ties go to those that were begun with or changed
  /// last; the same graph gives the same order.
  std::span<const int> find();

 private:
  struct Neighbours {
    std::size_t first = 0;  // in adjacent_
    int elements = 0;       // that come first,
    int variables = 0;      // and follow these
  };
  struct Element {
    std::size_t first = 0;  // in covered_
    int count = 0;          // of the variables that are left of it
    bool absorbed = false;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  void make_lists();
  void eliminate(int pivot);
  void cover(int pivot);
  void count_uncovered(int pivot);
  void update(int variable, int pivot);
  void insert(int variable);
  void remove(int variable);
  std::span<int> elements(int variable);
  std::span<int> variables(int variable);
  std::span<int> covered(int element);

  std::vector<int> couplings_;  // pairs
  std::vector<Neighbours> neighbours_;
  std::vector<int> adjacent_;
  std::vector<Element> elements_;  // by the variable that it was
  std::vector<int> covered_;
  std::vector<int> degrees_;
  std::vector<int> head_, next_, last_;  // lists of variables by degree
  std::vector<int> mark_;                // by variable: the pivot that covers it last
  std::vector<int> uncovered_;           // by element: of its variables, that the pivot does not cover
  std::vector<int> order_;
  int least_ = 0;  // degree that there may be
};

}  // namespace ribbon
