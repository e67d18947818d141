// A quiz for learning platforms, with drawings, right answers and reasons. Does not write files.
#pragma once

#include "apps/hidden/quiz/quiz_page.h"

#include <string>

namespace gw::apps {

/// A question bank in Moodle XML. A question is `multichoice`, with one answer or several, or
/// `numerical`; drawings are in it as files.
std::string moodle_xml(const QuizSheet& sheet);

/// An IMS QTI 2.1 package, a ZIP archive: imsmanifest.xml, test.xml, and an item and a drawing for
/// each question. An item's score is 1 or 0, the test's their sum.
std::string qti_package(const QuizSheet& sheet);

}  // namespace gw::apps
