#pragma once

#include "core/formula/formula.h"
#include "core/formula/syntax_error.h"
#include "core/scene/scene_fields.h"
#include "ui/panel/panel_context.h"
#include "ui/typeset/written_formula.h"

#include <array>
#include <optional>
#include <string>

namespace normalscope {

/// What is wrong with the text of a formula field; the column is that of a SyntaxError, or 0.
struct FormulaMistake {
    std::size_t column = 0;
    std::string message;
};

/// A formula's text while it is edited: it may be wrong, while the scene keeps the last one that was not.
class FormulaDraft {
public:
    /// Takes over the scene's formula where it has changed by other means than this draft, such as by undo. True where
    /// the text has been replaced.
    bool follow(const FormulaSurface& scene);
    /// The text stays as it is, mistake and all, beside a formula that it was not taken for.
    void stay(const FormulaSurface& scene);
    /// What has been typed goes to the scene if it can be read.
    void typed(FormulaSurface& scene);

    std::string text;
    const std::optional<FormulaMistake>& mistake() const { return mistake_; }

private:
    std::optional<std::string> followed_;  ///< the scene's formula as last seen
    std::optional<FormulaMistake> mistake_;
    std::string letters_;                              ///< the parameters of that formula
    formulas::Parameters values_ = formulas::kAllOne;  ///< of letters that are gone, too: they may come back
};

/// What the formula's part of the panel remembers.
struct FormulaMemory {
    FormulaDraft draft;
    FormulaSurface last;             ///< to return to after another kind of surface
    std::optional<double> typed_at;  ///< ImGui::GetTime of the last change that is no step to undo yet
    struct Before {
        FormulaSurface surface;
        std::string about;
    } before;                  ///< those changes
    bool focus = false;        ///< the field wants the keyboard
    bool selects_all = false;  ///< once it has it
    int frames_in_sight = 0;   ///< for how many frames more the field is not to be scrolled away
    /// Where the parameters' sliders begin and end.
    std::array<std::optional<Range>, formulas::kParameterNames.size()> ranges;

    std::optional<WrittenFormula> written;

    /// Seconds until something comes of what has been typed: its fine picture, and a step to undo; infinite if nothing has.
    double redraw_after() const;
    /// The next letter is likely to come at once.
    bool typing() const;
};

/// The field, what is wrong with its text, the sliders of the parameters, the bound, and the derivatives.
void formula_section(Scene& scene, FormulaMemory& memory, const PanelContext& context);

}  // namespace normalscope
