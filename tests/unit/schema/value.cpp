#include "schema/value.hpp"

#include <gtest/gtest.h>

using namespace corpuscle;

TEST(Value, WritesToml)
{
    Value inner;
    inner.put("a", Value::of_integer(1));
    inner.put("b c", Value::of_text("say \"x\"\n\\"));
    Value entry;
    entry.put("inner", inner);
    Value root;
    root.put("n", Value::of_number(2));
    root.put("list", Value::of_array({entry, entry}));
    root.put("t", Value::of_boolean(true));
    root.put("section", inner);
    root.put("empty", Value::of_array());
    EXPECT_EQ(toml_document(root),
              "n = 2.0\nt = true\nempty = []\n"
              "\n[[list]]\ninner = { a = 1, \"b c\" = \"say \\\"x\\\"\\n\\\\\" }\n"
              "\n[[list]]\ninner = { a = 1, \"b c\" = \"say \\\"x\\\"\\n\\\\\" }\n"
              "\n[section]\na = 1\n\"b c\" = \"say \\\"x\\\"\\n\\\\\"\n");
}

TEST(Value, PutReplacesAndFinds)
{
    Value table;
    table.put("a", Value::of_integer(1));
    table.put("a", Value::of_integer(2));
    ASSERT_NE(table.find("a"), nullptr);
    EXPECT_EQ(table.find("a")->integer, 2);
    EXPECT_EQ(table.items.size(), 1u);
    EXPECT_EQ(table.find("b"), nullptr);
}
