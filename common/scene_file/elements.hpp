// The elements of a scene file: keyword, fields, and effect on the scene.
#pragma once

#include "common/math/basis.hpp"
#include "common/scene_file/fields.hpp"
#include "common/scene_file/reader.hpp"

#include <span>
#include <string_view>

namespace rt {
inline namespace RT_PRECISION {

/// The options for reading elements.
struct ElementReading : SceneReading {
    BasisAround* orthonormal_basis = nullptr;
};

/// A kind of element in a scene file.
struct Element {
    ElementForm form;
    /// Reads the fields and options of the line, and adds the element to the scene.
    void (*read)(Fields& fields, const ElementReading& reading, Scene& scene);
    /// The effect of lenient reading on a second element of this kind, for the warning; null if the
    /// format allows several. "Elements defined by a capital letter can only be declared once"
    /// (miniRT's subject); several L are its bonus.
    const char* if_repeated = nullptr;
};

/// All elements, in the order of docs/scenes.md.
[[nodiscard]] std::span<const Element> elements();

/// Returns the element with this keyword; null if there is none.
[[nodiscard]] const Element* find_element(std::string_view keyword);

}  // namespace RT_PRECISION
}  // namespace rt
