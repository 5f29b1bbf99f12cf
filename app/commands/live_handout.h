#pragma once

#include "commands/files_of_run.h"
#include "core/scene/scene.h"

#include <map>
#include <string>

namespace normalscope {

/// What makes a handout's pictures wake to the program where they stand: `--live`. The page holds the program once, in a frame
/// that may do nothing but run scripts and comes over whichever picture is touched; on paper there are only the pictures.
class LiveHandout {
public:
    /// Throws InputError where the program as a page is not there.
    explicit LiveHandout(FilesOfRun& files);

    /// Of a picture's <img>: what it wakes to.
    std::string attributes(Scene scene);
    /// For the end of <head>.
    static std::string policy();
    /// For the end of <body>: the program, and the meshes of all scenes so far.
    std::string program() const;

private:
    std::string page_;
    std::map<std::string, std::string> names_;  ///< of the meshes, in the page, by their paths
};

}  // namespace normalscope
