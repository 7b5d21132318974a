// Known mistakes, recognized by the answers to all probes and by the cases of the suite that fail.
#pragma once

#include "common/contract/probes.hpp"

namespace rt::contract {

/// A known mistake, certain if all answers of a function and all cases are the mistake's.
struct Recognized {
    Mistake mistake;
    bool is_certain = true;
};

/// The mistakes that the answers to all probes, in their order, and the results of the suite show.
/// Each function with wrong answers is explained by the mistake that gives these answers. It is
/// recognized too where the function is right on some of the probes on which the mistake errs, and
/// where two mistakes together give all wrong answers: an answer's details are independent of each
/// other. A constant function identifies nothing. Of mistakes that explain a function equally well,
/// the one that explains more functions is recognized; if several do, with different sentences, all
/// are if they are certain, and otherwise none. Of an open function, most answers have to be of the
/// mistake's kind. Without results, the answers alone decide, and no mistake of an open function is
/// recognized.
[[nodiscard]] std::vector<Recognized> recognized(const Probes& probes,
                                                 const std::vector<Answer>& answers,
                                                 const CaseResults& results);

/// True if all answers of the function are equal, though the right ones are not: it is not written
/// yet, or an early return hides everything else.
[[nodiscard]] bool is_constant(const Probes& probes, const std::vector<Answer>& answers,
                               const Callee& callee);

}  // namespace rt::contract
