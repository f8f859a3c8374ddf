#include "core/scene/specification.h"

#include "core/scene/absolute_files.h"
#include "core/scene/scene_source.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

void specification(std::string_view input) {
    accepted({ErrorKind::Usage}, [&] {
        const Specification cut = cutSpecification(input, sceneGenerators());
        const std::string text = cut.text();
        require(cutSpecification(text, sceneGenerators()).text() == text, "a specification that is written is cut otherwise");
        const std::string same = withFiles(input, [](const std::string& file) { return file; });
        require(withFiles(same, [](const std::string& file) { return file; }) == same, "files that stay change a specification");
        (void)withAbsoluteFiles(std::string(input));
        GeneratorArguments arguments(cut);
        for (const GeneratorInfo& info : sceneGenerators()) {
            if (info.id != cut.generator) continue;
            for (const GeneratorParameter& parameter : info.parameters)
                (void)arguments.wholeNumber(parameter.key, 1.0, 0.0, 9e15);
            arguments.finish(info);
        }
    });
}

}  // namespace cullscope::fuzz
