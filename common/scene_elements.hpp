// The elements of a scene: keyword, fields, and what becomes of them.
#pragma once

#include "common/basis.hpp"
#include "common/scene_fields.hpp"
#include "common/scene_reading.hpp"

#include <span>
#include <string_view>

namespace rt::inline RT_PRECISION {

/// How elements are read.
struct ElementReading : SceneReading {
    BasisAround* basis_around = nullptr;
};

struct Element {
    ElementForm form;
    /// Takes the fields and options from the line and adds what they say to the scene.
    void (*read)(Fields& fields, const ElementReading& reading, Scene& scene);
    /// What lenient reading does about a second one; null if the format allows it. "Elements
    /// defined by a capital letter can only be declared once" (miniRT's subject); several L are
    /// its bonus.
    const char* if_repeated = nullptr;
};

/// All of them, in the order of docs/scenes.md.
[[nodiscard]] std::span<const Element> elements();

/// The element with this keyword; null if there is none.
[[nodiscard]] const Element* find_element(std::string_view keyword);

}  // namespace rt::inline RT_PRECISION
