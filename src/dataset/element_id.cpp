// SPDX-License-Identifier: Apache-2.0
#include "jprim/dataset/element_id.h"

#include "dataset/element_kinds.h"

namespace jprim {

const SpellingTable<ElementKind>& getElementKinds() {
    using E = ElementKind;
    static const SpellingTable<E> kinds = {{E::Jprim, "JPRIM", 2},     {E::Joint, "JOINT"},
                                           {E::Gcon, "GCON", 2},       {E::Motion, "MOTION"},
                                           {E::Coupler, "COUPLER", 3}, {E::Sforce, "SFORCE", 2},
                                           {E::Vforce, "VFORCE", 2},   {E::Vtorque, "VTORQUE", 2},
                                           {E::Gforce, "GFORCE", 2},   {E::Springdamper, "SPRINGDAMPER", 2},
                                           {E::Bushing, "BUSHING", 2}, {E::Sensor, "SENSOR", 2}};
    return kinds;
}

const char* getAdamsName(ElementKind kind) {
    return getElementKinds().getName(kind).data();
}

std::optional<ElementKind> findElementKind(std::string_view keyword) {
    const std::vector<Word>& words = getElementKinds().getWords();
    for (std::size_t k = 0; k < words.size(); ++k)
        if (words[k].name == keyword) return getElementKinds().getValue(k);
    return std::nullopt;
}

std::string ElementId::getText() const {
    return getAdamsName(kind) + ("/" + std::to_string(number));
}

}  // namespace jprim
