#include <fmt/format.h>

#include "app/commands/commands.hpp"
#include "base/error.hpp"
#include "schema/manual.hpp"

namespace corpuscle {

int explain_command(const Options& options)
{
    const Table& root = table_of<CaseDescription>();
    if (options.markdown) {
        fmt::print("{}", reference_page(root));
    } else if (options.subject.empty()) {
        for (const Parameter& row : root.rows) fmt::print("{:10} {}\n", row.key, row.meaning);
        fmt::print("\n`corpuscle explain KEY` tells more, such as `corpuscle explain charge.mass`.\n");
    } else {
        fmt::print("{}", explain(root, options.subject));
    }
    return 0;
}

}  // namespace corpuscle
