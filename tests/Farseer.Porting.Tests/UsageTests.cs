using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using FarseerGames.FarseerPhysics;
using Xunit;
using Xunit.Abstractions;

namespace Farseer.Porting.Tests
{
    /// <summary>
    /// What real programs used of version 2.0.1 (tests/data/usage.tsv), of later versions and of XNA: it compiles, or docs/Porting.md
    /// explains it.
    /// </summary>
    public sealed class UsageTests
    {
        /// <summary>XNA's types of mathematics; the others are explained by part or by name.</summary>
        private static readonly string[] Mathematics = { "MathHelper", "Matrix", "Vector3", "Vector4" };

        private readonly ITestOutputHelper _output;

        public UsageTests(ITestOutputHelper output)
        {
            _output = output;
        }

        [Fact]
        public void EveryRow_OfTheUsageTable_CompilesOrIsExplained()
        {
            string[] rows = PortingGuide.Rows("usage.tsv");
            Assert.Equal(382, rows.Length);
            string[] failures = UsageCompiler.Failures(rows);
            string[] uncovered = failures.Where(row => !IsExplained(row, "API differences")).ToArray();
            _output.WriteLine($"{uncovered.Length} rows uncovered ({rows.Length - failures.Length} of {rows.Length} compile)");
            Assert.True(uncovered.Length == 0, $"{uncovered.Length} rows uncovered:\n{string.Join('\n', uncovered)}");

            // What the document says of the table is what was found.
            double share = (double)(Uses(rows) - Uses(failures)) / Uses(rows);
            string found = string.Create(
                CultureInfo.InvariantCulture,
                $"Compiles unchanged: {rows.Length - failures.Length} of {rows.Length} members, {share * 100:0.#} % of {Uses(rows):#,0} "
                    + $"uses.");
            Assert.Contains(found, PortingGuide.Text, StringComparison.Ordinal);
        }

        [Fact]
        public void EveryRow_OfXnasMathematics_Compiles()
        {
            string[] rows = PortingGuide.Rows("usage-xna.tsv");
            string[] maths = rows.Where(IsMathematics).ToArray();
            string[] failures = UsageCompiler.Failures(maths);
            _output.WriteLine($"{failures.Length} rows of mathematics uncovered ({maths.Length} rows, {Uses(maths)} uses)");
            Assert.True(failures.Length == 0, $"{failures.Length} rows do not compile:\n{string.Join('\n', failures)}");
            Assert.Contains(
                $"use {rows.Length} members of XNA besides. {maths.Length} of them", PortingGuide.Text, StringComparison.Ordinal);
        }

        [Fact]
        public void EveryRow_OfTheRestOfXna_IsExplainedByItsPartOrType()
        {
            string[] rows = PortingGuide.Rows("usage-xna.tsv").Where(row => !IsMathematics(row)).ToArray();
            string section = PortingGuide.Section("What the programs use of XNA");
            string[] uncovered = rows
                .Where(row => !section.Contains($"`{row.Split('\t')[0]}`") && !section.Contains($"`{row.Split('\t')[1]}`"))
                .ToArray();
            _output.WriteLine($"{uncovered.Length} rows of the rest uncovered ({rows.Length} rows)");
            Assert.True(uncovered.Length == 0, $"{uncovered.Length} rows uncovered:\n{string.Join('\n', uncovered)}");
        }

        [Fact]
        public void EveryMember_OfOtherVersions_IsExplained()
        {
            string[] rows = PortingGuide.Rows("usage-not-in-2.0.1.tsv");
            string[][] table = PortingGuide.Table("Members of other versions");
            foreach (string[] row in rows.Select(r => r.Split('\t')))
            {
                string[] explained = table.SingleOrDefault(cells => cells[1].Contains($"`{row[0]}`"));
                Assert.True(explained != null, $"{row[0]} has no line.");
                Assert.Equal(row[2], explained[0]);
                Assert.Equal(Exists(row[0]), explained[2].StartsWith("the same", StringComparison.Ordinal));

                // What the line points at is there.
                Assert.All(
                    Regex.Matches(explained[2], @"`([A-Z]\w+\.\w+)`").Select(m => m.Groups[1].Value),
                    name => Assert.True(Exists(name), $"{row[0]}: there is no {name}."));
            }
        }

        [Fact]
        public void AWrongUse_DoesNotCompile()
        {
            HashSet<int> broken =
                UsageCompiler.Broken("class Uses {\nstatic void M0(Body x) { x.Flies(); }\nstatic void M1(Body x) { x.Dispose(); }\n}");
            Assert.Equal(new[] { 1 }, broken);
            Assert.Equal(
                new[] { "N\tBody\tmethod\tFlies()\t1\t1" },
                UsageCompiler.Failures(new[] { "N\tBody\tmethod\tFlies()\t1\t1", "N\tBody\tmethod\tDispose()\t1\t1" }));
        }

        private static bool IsMathematics(string row)
        {
            string[] cells = row.Split('\t');
            return cells[0] == "Microsoft.Xna.Framework" && Mathematics.Contains(cells[1]);
        }

        private static bool IsExplained(string row, string section)
        {
            string[] cells = row.Split('\t');
            string member = cells[3].Split('(')[0];
            return PortingGuide.Section(section).Contains($"`{cells[1]}.{member}`", StringComparison.Ordinal);
        }

        private static long Uses(string[] rows) => rows.Sum(row => long.Parse(row.Split('\t')[5], CultureInfo.InvariantCulture));

        private static bool Has(Type type, string member) =>
            type != null && type.GetMember(member, BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static).Length > 0;

        private static bool Exists(string name)
        {
            string[] parts = name.Split('.');
            Type type = typeof(PhysicsSimulator).Assembly.GetExportedTypes().Concat(new[] { typeof(Vector2) })
                .FirstOrDefault(t => t.Name == parts[0]);
            Type added = typeof(PhysicsSimulator).Assembly.GetType("FarseerGames.FarseerPhysics.Porting." + parts[0] + "Porting");
            return Has(type, parts[1]) || Has(added, parts[1]);
        }
    }
}
