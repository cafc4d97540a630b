// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_DATASET_ELEMENT_ID_H_
#define JPRIM_DATASET_ELEMENT_ID_H_

#include <optional>
#include <string>
#include <string_view>
#include <tuple>

namespace jprim {

/// The kinds of statement that act between markers or watch them: what ACTIVATE and DEACTIVATE can name. Constraints
/// come first, then forces.
enum class ElementKind {
    Jprim,
    Joint,
    Gcon,
    Motion,
    Coupler,
    Sforce,
    Vforce,
    Vtorque,
    Gforce,
    Springdamper,
    Bushing,
    Sensor
};

/// JPRIM to COUPLER.
[[nodiscard]] constexpr bool isConstraint(ElementKind kind) {
    return kind <= ElementKind::Coupler;
}

/// The keyword of the statement: "JPRIM".
[[nodiscard]] const char* getAdamsName(ElementKind kind);
/// The kind with this keyword, in full and upper case.
[[nodiscard]] std::optional<ElementKind> findElementKind(std::string_view keyword);

/// Which statement an element is: each kind has numbers of its own.
struct ElementId {
    ElementKind kind = ElementKind::Jprim;
    int number = 0;

    /// "JPRIM/12".
    [[nodiscard]] std::string getText() const;
};

inline bool operator==(const ElementId& a, const ElementId& b) {
    return a.kind == b.kind && a.number == b.number;
}
inline bool operator!=(const ElementId& a, const ElementId& b) {
    return !(a == b);
}
inline bool operator<(const ElementId& a, const ElementId& b) {
    return std::tie(a.kind, a.number) < std::tie(b.kind, b.number);
}

}  // namespace jprim

#endif
