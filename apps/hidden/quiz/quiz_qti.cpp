// IMS Question and Test Interoperability 2.1 (2012): Assessment Test, Section, and Item; Content
// Packaging 1.1.
#include "apps/hidden/quiz/quiz_export.h"
#include "apps/hidden/quiz/zip.h"
#include "hiddensurface/quiz/quiz_drawing.h"

#include <fmt/format.h>

#include <sstream>

namespace gw::apps {

namespace hs = hiddensurface;

namespace {

constexpr const char* qti_head =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<{0} "
    "xmlns=\"http://www.imsglobal.org/xsd/imsqti_v2p1\" "
    "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
    "xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imsqti_v2p1 "
    "http://www.imsglobal.org/xsd/qti/qtiv2p1/imsqti_v2p1.xsd\" "
    "identifier=\"{1}\" title=\"{2}\"";

constexpr const char* score =
    "<outcomeDeclaration identifier=\"SCORE\" cardinality=\"single\" baseType=\"float\">"
    "<defaultValue><value>0</value></defaultValue></outcomeDeclaration>\n";

QuizHtml qti_html(const QuizSheet& sheet) { return {sheet.language, "xml:lang"}; }

/// Choices a, b, c, ..., or n1, n2, ... of which several are right, or a whole number.
struct Response {
    const char *cardinality, *type;
    std::vector<std::string> right;
    std::string interaction;
};

Response response_of(const hs::Question& question, const QuizHtml& html) {
    const bool are_several = question.among > 0;
    if (question.choices.empty() && !are_several)
        return {"single",
                "integer",
                {question.answer},
                "<p>" + html.spans({"Answer", "解答"}) +
                    ": <textEntryInteraction responseIdentifier=\"RESPONSE\" "
                    "expectedLength=\"4\"/></p>\n"};
    std::string list = fmt::format(
        "<choiceInteraction responseIdentifier=\"RESPONSE\" shuffle=\"false\" "
        "maxChoices=\"{}\">\n",
        are_several ? 0 : 1);
    const auto add = [&](const std::string& identifier, const std::string& text) {
        list +=
            fmt::format("<simpleChoice identifier=\"{}\">{}</simpleChoice>\n", identifier, text);
    };
    for (int number = 1; number <= question.among; ++number)
        add(fmt::format("n{}", number), std::to_string(number));
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        add(std::string(1, char('a' + i)), html.lines(question.choices[i]));
    Response response{
        are_several ? "multiple" : "single", "identifier", {}, list + "</choiceInteraction>\n"};
    std::istringstream words(question.answer);
    for (std::string word; words >> word;)
        response.right.push_back((are_several ? "n" : "") + word);
    return response;
}

std::string item_of(const QuizSheet& sheet, std::size_t i, const std::string& name,
                    const std::string& picture) {
    const QuizHtml html = qti_html(sheet);
    const hs::Question& question = sheet.questions[i];
    const Response response = response_of(question, html);
    const std::string spoken = escaped_xml(html.plain(hs::drawing_in_words(question)));
    std::string right;
    for (const std::string& value : response.right) right += "<value>" + value + "</value>";
    const std::string title = escaped_xml(html.plain(hs::title_of_kind(question.kind)));
    return fmt::format(fmt::runtime(qti_head), "assessmentItem", name, title) +
           " adaptive=\"false\" timeDependent=\"false\">\n" +
           fmt::format(
               "<responseDeclaration identifier=\"RESPONSE\" cardinality=\"{}\" baseType=\"{}\">"
               "<correctResponse>{}</correctResponse></responseDeclaration>\n{}"
               "<outcomeDeclaration identifier=\"FEEDBACK\" cardinality=\"single\" "
               "baseType=\"identifier\"/>\n",
               response.cardinality, response.type, right, score) +
           fmt::format(
               "<itemBody>\n<div>\n{}<p><img src=\"{}\" alt=\"{}\" width=\"480\" "
               "height=\"360\"/></p>\n{}{}</div>\n</itemBody>\n",
               html.paragraphs(question.text), picture, spoken, html.corner_table(question),
               response.interaction) +
           "<responseProcessing>\n<responseCondition>\n"
           "<responseIf><match><variable identifier=\"RESPONSE\"/><correct "
           "identifier=\"RESPONSE\"/></match>"
           "<setOutcomeValue identifier=\"SCORE\"><baseValue baseType=\"float\">1</baseValue>"
           "</setOutcomeValue></responseIf>\n"
           "<responseElse><setOutcomeValue identifier=\"SCORE\"><baseValue "
           "baseType=\"float\">0</baseValue></setOutcomeValue></responseElse>\n"
           "</responseCondition>\n"
           "<setOutcomeValue identifier=\"FEEDBACK\"><baseValue "
           "baseType=\"identifier\">why</baseValue></setOutcomeValue>\n</responseProcessing>\n" +
           fmt::format(
               "<modalFeedback outcomeIdentifier=\"FEEDBACK\" identifier=\"why\" "
               "showHide=\"show\">{}</modalFeedback>\n</assessmentItem>\n",
               html.paragraphs(question.why));
}

std::string test_of(const QuizSheet& sheet, const std::vector<std::string>& items) {
    const std::string title =
        qti_html(sheet).plain({"Hidden surfaces", "隠面消去"}) + fmt::format(", {}", sheet.seed);
    std::string refs;
    for (const std::string& name : items)
        refs += fmt::format("<assessmentItemRef identifier=\"{0}\" href=\"{0}.xml\"/>\n", name);
    return fmt::format(fmt::runtime(qti_head), "assessmentTest", fmt::format("test_{}", sheet.seed),
                       title) +
           ">\n" + score +
           "<testPart identifier=\"part\" navigationMode=\"nonlinear\" "
           "submissionMode=\"individual\">\n<assessmentSection identifier=\"section\" title=\"" +
           title + "\" visible=\"true\">\n" + refs +
           "</assessmentSection>\n</testPart>\n<outcomeProcessing><setOutcomeValue "
           "identifier=\"SCORE\"><sum><testVariables variableIdentifier=\"SCORE\"/></sum>"
           "</setOutcomeValue></outcomeProcessing>\n</assessmentTest>\n";
}

std::string manifest_of(const QuizSheet& sheet, const std::vector<std::string>& items,
                        const std::vector<std::string>& pictures) {
    std::string resources =
        "<resource identifier=\"test\" type=\"imsqti_test_xmlv2p1\" href=\"test.xml\">\n"
        "<file href=\"test.xml\"/>\n";
    for (const std::string& name : items)
        resources += fmt::format("<dependency identifierref=\"{}\"/>\n", name);
    resources += "</resource>\n";
    for (std::size_t i = 0; i < items.size(); ++i)
        resources += fmt::format(
            "<resource identifier=\"{0}\" type=\"imsqti_item_xmlv2p1\" href=\"{0}.xml\">\n"
            "<file href=\"{0}.xml\"/>\n<file href=\"{1}\"/>\n</resource>\n",
            items[i], pictures[i]);
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<manifest "
        "xmlns=\"http://www.imsglobal.org/xsd/imscp_v1p1\" "
        "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
        "xsi:schemaLocation=\"http://www.imsglobal.org/xsd/imscp_v1p1 "
        "http://www.imsglobal.org/xsd/qti/qtiv2p1/qtiv2p1_imscpv1p2_v1p0.xsd\" "
        "identifier=\"quiz_{}\">\n<metadata><schema>QTIv2.1 Package</schema>"
        "<schemaversion>1.0.0</schemaversion></metadata>\n<organizations/>\n<resources>\n{}"
        "</resources>\n</manifest>\n",
        sheet.seed, resources);
}

}  // namespace

std::string qti_package(const QuizSheet& sheet) {
    std::vector<std::string> items, pictures;
    std::vector<std::pair<std::string, std::string>> files;
    for (std::size_t i = 0; i < sheet.questions.size(); ++i) {
        items.push_back(fmt::format("question_{}_{:02}", sheet.seed, i + 1));
        pictures.push_back(fmt::format("picture_{}_{:02}.svg", sheet.seed, i + 1));
        const hs::Question& question = sheet.questions[i];
        const std::string spoken =
            escaped_xml(qti_html(sheet).plain(hs::drawing_in_words(question)));
        files.emplace_back(items[i] + ".xml", item_of(sheet, i, items[i], pictures[i]));
        files.emplace_back(pictures[i], hs::drawing_of(question, spoken));
    }
    files.insert(files.begin(), {"test.xml", test_of(sheet, items)});
    files.insert(files.begin(), {"imsmanifest.xml", manifest_of(sheet, items, pictures)});
    return zip_of(files);
}

}  // namespace gw::apps
