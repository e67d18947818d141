// The command gw.
#include "apps/command.h"
#include "image/temporaries.h"

int main(int count, char** arguments) {
    gw::image::remove_temporaries_on_signals();
    return gw::apps::run({arguments + 1, arguments + count});
}
