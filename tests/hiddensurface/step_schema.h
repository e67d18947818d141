// steps.schema.json for tests: whether a line of JSON obeys it.
#pragma once

#include "test_paths.h"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <fstream>
#include <string>

namespace gw::hiddensurface {

class StepSchema {
public:
    /// Of the lines of a log, or of one of the schema's definitions.
    explicit StepSchema(const std::string& definition = "") {
        auto json = nlohmann::json::parse(
            std::ifstream(GW_SOURCE_DIR "/hiddensurface/run/steps.schema.json"));
        if (!definition.empty()) json["anyOf"] = {{{"$ref", "#/definitions/" + definition}}};
        valijson::SchemaParser(valijson::SchemaParser::kDraft7)
            .populateSchema(valijson::adapters::NlohmannJsonAdapter(json), schema_);
    }
    bool holds_for(const std::string& text) const {
        const auto json = nlohmann::json::parse(text);
        return valijson::Validator().validate(
            schema_, valijson::adapters::NlohmannJsonAdapter(json), nullptr);
    }

private:
    valijson::Schema schema_;
};

}  // namespace gw::hiddensurface
