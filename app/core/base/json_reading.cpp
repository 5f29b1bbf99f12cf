#include "core/base/json_reading.h"

#include "core/base/json_path.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace normalscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestReason = 200;  // which quotes what could not be read

/// Builds the value as the parser goes, so that what is wrong is known by its path.
class Builder : public nlohmann::json_sax<Json> {
public:
    explicit Builder(std::string_view text) : text_(text) {}

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }  // text has none
    bool start_object(std::size_t) override { return open(Json::object()); }
    bool start_array(std::size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        Open& object = open_.back();
        object.key = key;
        if (object.keys.insert(key).second) return true;
        return refuse("is there twice; keep one");
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& error) override {
        if (const std::string word = word_at(position); error.id == 406 || is_no_number(word))
            return refuse(shortened(word, 40) +
                          (error.id == 406 ? " is too large for a number" : " is not a number in JSON"));
        syntax = true;
        if (text_.find_first_not_of(" \t\r\n") == std::string_view::npos) {
            fault = JsonError({}, "not valid JSON: it is empty");
            return false;
        }
        std::string reason = error.what();  // without its head, "[json.exception…]"
        if (const auto end = reason.find("] "); reason.starts_with('[') && end != std::string::npos)
            reason.erase(0, end + 2);
        fault = JsonError({}, "not valid JSON: " + shortened(reason, kLongestReason));
        return false;
    }

    Json root;
    std::optional<JsonError> fault;
    bool syntax = false;  ///< the fault is that it is no JSON

private:
    struct Open {
        Json* value;
        std::string key;
        std::set<std::string> keys;
    };

    Json& place(Json value) {
        if (open_.empty()) return root = std::move(value);
        Json& parent = *open_.back().value;
        if (parent.is_array()) return parent.emplace_back(std::move(value));
        // Not by [], which looks through all that are there.
        return parent.get_ref<Json::object_t&>().emplace_back(open_.back().key, std::move(value)).second;
    }
    bool add(Json value) { return place(std::move(value)), true; }
    bool open(Json value) {
        if (open_.size() == kDeepestJson) {
            fault = JsonError(
                {}, "nested more than " + std::to_string(kDeepestJson) + " levels deep, which nothing here is");
            return false;
        }
        open_.push_back({&place(std::move(value)), {}, {}});
        return true;
    }
    bool close() { return open_.pop_back(), true; }

    bool refuse(const std::string& reason) {
        JsonPath path;
        for (const Open& open : open_) {
            // What is being read in an array is not in it yet; what is open within it is its last.
            const std::size_t index = open.value->size() - (&open == &open_.back() ? 0 : 1);
            path.push_back(open.value->is_array() ? std::to_string(index) : open.key);
        }
        fault = JsonError(std::move(path), reason);
        return false;
    }

    // The parser stops in the middle of what it does not understand, or after it.
    std::string word_at(std::size_t position) const {
        constexpr std::string_view kEnds = ",:[]{} \t\r\n\"";
        const std::size_t at = std::min(position, text_.size());
        const std::size_t before = text_.substr(0, at == 0 ? 0 : at - 1).find_last_of(kEnds);
        const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
        return std::string(text_.substr(begin, std::min(text_.find_first_of(kEnds, begin), text_.size()) - begin));
    }
    static bool is_no_number(std::string_view word) {
        if (word.starts_with('-')) word.remove_prefix(1);
        return word == "NaN" || word == "nan" || word == "Infinity" || word == "inf";
    }

    std::string_view text_;
    std::vector<Open> open_;
};

}  // namespace

Json read_json(std::string_view text) {
    Builder builder(text);
    Json::sax_parse(text, &builder);
    if (builder.fault) throw JsonError(*std::move(builder.fault));
    return std::move(builder.root);
}

std::optional<Json> read_json_or_nothing(std::string_view text) {
    Builder builder(text);
    Json::sax_parse(text, &builder);
    if (builder.syntax) return std::nullopt;
    if (builder.fault) throw JsonError(*std::move(builder.fault));
    return std::move(builder.root);
}

}  // namespace normalscope
