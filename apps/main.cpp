// The command gw.
#include "apps/command.h"
#include "apps/terminal.h"
#include "image/temporaries.h"

int main(int count, char** arguments) {
    gw::apps::hold_standard_streams();
    gw::image::remove_temporaries_on_signals();
    return gw::apps::run({arguments + 1, arguments + count});
}
