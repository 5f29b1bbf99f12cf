#pragma once

#include "cli/commands.h"

namespace normalscope {

// What each command does, in a file of its own. Returns the exit code: 0, 1 where pictures differ or a check fails, or
// as CancelOnSignal has it. Throws UsageError, InputError and ContextError.

int run(const CaptureCommand& command);
/// Many pictures of one scene, one for each value (or pair of values) of what varies.
int run(const SweepCommand& command);
int run(const ExplainCommand& command);
int run(const ScenesCommand& command);
int run(const LessonsCommand& command);
/// Its files, each with what is wrong in it: 1 where there is anything.
int check_lessons(const LessonsCommand& command);
/// A lesson as an HTML page that needs nothing beside it: a picture, its caption and its equations a step, and the
/// answers to the questions at the end.
int run(const HandoutCommand& command);
/// A lesson as a folder of pictures, and a page that shows each with its words.
int run(const SlidesCommand& command);
/// Its questions as Moodle XML, with their pictures; of exercises, numbers to be filled in.
int run(const QuizCommand& command);
/// A lesson from its first step to its last, with its captions, as a video or numbered pictures.
int run(const AnimateCommand& command);
/// Compares two pictures and prints one line that says how far they are apart.
int run(const CompareCommand& command);
/// Draws a manifest's scenes and judges each; with `update` it accepts what was drawn.
int run(const CheckCommand& command);
int run(const Printed& command);

}  // namespace normalscope
