pytest_plugins = ["gw.testing"]
