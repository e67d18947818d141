// CLI11's application, for declarations: its own header takes a compiler seconds. Does not define
// it.
#pragma once

namespace CLI {
class App;
}
