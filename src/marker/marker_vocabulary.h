// SPDX-License-Identifier: Apache-2.0
#ifndef JPRIM_SRC_MARKER_MARKER_VOCABULARY_H_
#define JPRIM_SRC_MARKER_MARKER_VOCABULARY_H_

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "expression/compile_expression.h"
#include "marker/marker_frames.h"

namespace jprim {

/// Adams' measures of markers, as Expression lists them, and VARVAL(id), a variable's expression in its place, for
/// the expression compiler.
class MarkerVocabulary : public Vocabulary {
public:
    explicit MarkerVocabulary(MarkerFrames& frames) : m_frames(frames) {}

    std::optional<Operand> call(ProgramBuilder& builder, const Call& call) override;
    std::vector<std::string> getNames() const override;
    const InterpolatingSpline* findSpline(int) override { return nullptr; }

protected:
    MarkerFrames& updFrames() { return m_frames; }

    /// The ids in the call's arguments; those left out are 0. @throws ExpressionError unless there are
    /// `least` to `most` of them
    static std::vector<int> getIds(const Call& call, int least, int most);
    /// @throws ExpressionError if the argument is not 0 and names no marker
    void checkMarker(const Call& call, size_t argument, int id) const;
    /// Why a marker cannot be measured that MarkerFrames does not find.
    virtual std::string describeMissing(int id) const;
    /// The text of a variable, or null.
    virtual const std::string* findVariable(int) const { return nullptr; }
    /// The value of the VARIABLE with an id, which stands at `idOffset` of a call at `offset`.
    Operand makeVariable(ProgramBuilder& builder, int id, size_t offset, size_t idOffset);
    /// What has a name of its own is compiled into a program once.
    /// @throws ExpressionError if it is being compiled already
    Operand makeNamed(const std::string& name, size_t offset, const std::function<Operand()>& make);

private:
    MarkerFrames& m_frames;
    std::map<std::string, Operand> m_named;  // compiled into this program already
    std::vector<std::string> m_open;         // being compiled, outermost first
};

}  // namespace jprim

#endif
