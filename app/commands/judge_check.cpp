#include "commands/judge_check.h"

#include "commands/evidence.h"
#include "commands/report.h"
#include "core/base/base64.h"
#include "core/base/error.h"
#include "core/base/file.h"
#include "core/base/output.h"
#include "core/base/system.h"
#include "core/image/png.h"
#include "core/image/shrunk.h"

#include <nlohmann/json.hpp>

namespace normalscope {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

class Judge {
public:
    Judge(const CheckCommand& command, const Check& check, Capture capture)
        : command_(command),
          check_(check),
          actual_(std::move(capture.image)),
          numbers_(Json::parse(capture.numbers)),
          notes_(std::move(capture.notes)) {}

    CheckResult judge() {
        if (check_.reference) judge_picture();
        for (const std::string& line : wrong_numbers(numbers_, check_.numbers)) {
            fail(line);
            result_.numbers_wrong = true;
        }
        if (result_.line.empty()) result_.line = "the numbers are as expected";
        for (const std::string& note : notes_) {
            if (command_.fail_on_note) {
                fail("note: " + note);
                result_.numbers_wrong = true;
            } else {
                add_line("note: " + note);
            }
        }
        if (result_.state != CheckState::Pass) leave_actual();
        if (command_.report) show_actual();
        result_.name = check_.name;
        result_.details = details_.dump();
        return std::move(result_);
    }

private:
    void add_line(const std::string& line) { result_.line += (result_.line.empty() ? "" : "; ") + line; }
    void fail(const std::string& line) {
        if (result_.state == CheckState::Pass) result_.line.clear();  // what agrees is of no interest any more
        result_.state = CheckState::Fail;
        add_line(line);
    }

    void judge_picture() {
        std::error_code ignored;
        if (!fs::exists(*check_.reference, ignored)) {
            result_.reference_differs = true;
            return fail("there is no reference " + check_.reference->string() +
                        (command_.update ? " yet" : "; --update writes it"));
        }
        const Image expected = reference();
        const Verdict verdict = ::normalscope::judge(actual_, expected, check_.tolerance);
        details_["verdict"] = verdict.json();
        if (verdict.agree) {
            result_.line = verdict.line();
            return;
        }
        fail(verdict.line());
        result_.reference_differs = true;
        if (command_.report) {
            details_["pictures"]["expected"] = base64(png_bytes(expected));
            if (!too_large_to_show(actual_.size, expected.size))
                details_["pictures"]["difference"] = base64(png_bytes(highlighted(verdict, expected)));
        }
        evident([&] {
            const fs::path file = evidence_file(command_, check_);
            for (const fs::path& left : leave_evidence(file, *check_.reference, actual_, expected, check_.tolerance))
                result_.evidence.push_back(left);
        });
    }

    Image reference() const {
        try {
            return read_png(*check_.reference);
        } catch (const InputError& e) {
            throw InputError(e.what() + std::string("; delete it, and --update writes it anew"));
        }
    }

    void leave_actual() {
        evident([&] {
            const fs::path file = evidence_file(command_, check_);
            const std::string bytes = png_bytes(actual_);
            write_file(file, bytes);
            result_.drawn = hash_of(bytes);
            result_.evidence.push_back(file);
        });
    }

    // What passes is there to be recognised, not to be looked into: small.
    void show_actual() {
        constexpr int kSmall = 320;
        const bool passes = result_.state == CheckState::Pass;
        details_["pictures"]["actual"] = base64(png_bytes(passes ? shrunk(actual_, kSmall) : actual_));
        details_["numbers"] = numbers_;
    }

    // What is found counts, even where its pictures find no room. The folder is made when there is something to put into
    // it; another run may take it away, since it was empty, before this one gets to that.
    template <class Write>
    void evident(Write&& write) {
        for (int attempt = 1;; ++attempt) try {
                make_folder(command_.results);
                return write();
            } catch (const InputError& e) {
                std::error_code ignored;
                if (attempt < 3 && !fs::exists(command_.results, ignored)) continue;
                return fail(e.what());
            }
    }

    // The last third of the difference's picture.
    Image highlighted(const Verdict& verdict, const Image& expected) const {
        const Image all = difference_picture(actual_, expected, verdict.tolerance);
        const glm::ivec2 size = glm::max(actual_.size, expected.size);
        return cropped(all, {all.size.x - size.x, 0}, size);
    }

    const CheckCommand& command_;
    const Check& check_;
    Image actual_;
    Json numbers_;
    std::vector<std::string> notes_;
    Json details_ = Json::object();
    CheckResult result_{.name = {}, .state = CheckState::Pass, .line = {}};
};

}  // namespace

fs::path evidence_file(const CheckCommand& command, const Check& check) {
    std::string name = check.name;
    for (char& c : name)
        if (never_in_names().find(c) != std::string_view::npos || static_cast<unsigned char>(c) < ' ') c = '-';
    return command.results / (name + ".png");
}

CheckResult judge_check(const CheckCommand& command, const Check& check, Capture capture) {
    return Judge(command, check, std::move(capture)).judge();
}

CheckResult error_result(const Check& check, const std::string& reason) {
    return {.name = check.name, .state = CheckState::Error, .line = reason};
}

// FNV-1a (Fowler, Noll and Vo): nobody forges these pictures, they only get mixed up.
std::uint64_t hash_of(std::string_view bytes) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return hash;
}

}  // namespace normalscope
