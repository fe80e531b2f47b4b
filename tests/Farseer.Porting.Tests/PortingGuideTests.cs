using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace Farseer.Porting.Tests
{
    /// <summary>The tables of docs/Porting.md begin with what real programs use most, and count it rightly.</summary>
    public sealed class PortingGuideTests
    {
        [Theory]
        [InlineData("API differences")]
        [InlineData("Quirks")]
        [InlineData("Behaviour that differs on purpose")]
        public void Table_OfDifferences_CountsTheUsesOfItsMembers(string heading)
        {
            foreach (string[] row in PortingGuide.Table(heading))
            {
                Assert.Equal(Uses(row[1]), row[0]);
            }
        }

        [Theory]
        [InlineData("API differences")]
        [InlineData("Quirks")]
        [InlineData("Behaviour that differs on purpose")]
        [InlineData("Members of other versions")]
        public void Table_OfDifferences_BeginsWithWhatIsUsedMost(string heading)
        {
            int[] uses =
                PortingGuide.Table(heading).Select(row => row[0] == "–" ? -1 : int.Parse(row[0], CultureInfo.InvariantCulture)).ToArray();
            Assert.NotEmpty(uses);
            Assert.Equal(uses.OrderByDescending(n => n), uses);
        }

        /// <summary>
        /// Of the members in a cell: `Type` is how often the type is named, `Type.Member` all overloads, `Type.Member(…, X)` those whose
        /// parameters end so. – if the cell names no member.
        /// </summary>
        private static string Uses(string cell)
        {
            var counted = new HashSet<string>();
            bool names = false;
            foreach (Match code in Regex.Matches(cell, @"`([A-Z]\w*)(?:\.(\w+)(\(.*?\))?)?`"))
            {
                names = true;
                string type = code.Groups[1].Value, member = code.Groups[2].Value, parameters = code.Groups[3].Value;
                counted.UnionWith(PortingGuide.Rows("usage.tsv").Where(row => Is(row.Split('\t'), type, member, parameters)));
            }

            return names
                ? counted.Sum(row => int.Parse(row.Split('\t')[5], CultureInfo.InvariantCulture)).ToString(CultureInfo.InvariantCulture)
                : "–";
        }

        private static bool Is(string[] row, string type, string member, string parameters)
        {
            if (row[1] != type || (row[2] == "type") != (member.Length == 0))
            {
                return false;
            }

            string name = row[3].Split('(')[0];
            bool same = member.Length == 0 || name == member || name == "add_" + member;
            bool ends = parameters.StartsWith("(…", StringComparison.Ordinal)
                ? row[3].EndsWith(parameters.Substring(2), StringComparison.Ordinal)
                : row[3] == member + parameters;
            return same && (parameters.Length == 0 || ends);
        }
    }
}
