// The command gw.
#include "apps/command/command.h"
#include "apps/command/early_end.h"
#include "apps/command/terminal.h"
#include "image/output/temporaries.h"

int main(int count, char** arguments) {
    gw::apps::hold_standard_streams();
    gw::image::remove_temporaries_on_signals();
    gw::apps::end_clearly_on_terminate();
    return gw::apps::run({arguments + 1, arguments + count});
}
