using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Reflection.Metadata;
using System.Reflection.PortableExecutable;
using System.Xml.Linq;
using Xunit;

namespace Farseer.Package.Tests;

/// <summary>What is inside the package and its symbols.</summary>
[Collection(PackageCollection.Name)]
public sealed class ContentTests(PackedLibrary library)
{
    private static readonly string[] _frameworks = ["netstandard2.0", "net8.0"];

    [Fact]
    public void Package_HoldsBothAssemblies_ForBothFrameworks_WithDocumentation()
    {
        string[] expected =
        [
            .. _frameworks.SelectMany(f => new[] { "Farseer.dll", "Farseer.Engine.dll", "Farseer.xml" }.Select(n => $"lib/{f}/{n}")),
            "build/Farseer.targets", "buildTransitive/Farseer.targets", "README.md", "CHANGELOG.md", "icon.png", "Farseer.nuspec",
        ];
        using ZipArchive package = ZipFile.OpenRead(library.Package);

        IEnumerable<string> present = package.Entries.Select(e => e.FullName)
            .Where(n => !n.StartsWith("_rels/", StringComparison.Ordinal)
                && !n.StartsWith("package/", StringComparison.Ordinal)
                && n != "[Content_Types].xml");

        Assert.Equal(expected.Order(StringComparer.Ordinal), present.Order(StringComparer.Ordinal));
    }

    [Theory]
    [InlineData("Farseer.Box2DFlash")]
    [InlineData("Farseer.Viewer")]
    public void DependentPackage_HoldsItsAssemblyAlone_AndAsksForTheSameVersionOfFarseer(string name)
    {
        using ZipArchive package = ZipFile.OpenRead(library.PackageOf(name));
        using Stream stream = package.GetEntry(name + ".nuspec")!.Open();
        XElement metadata = XDocument.Load(stream).Root!.Elements().Single();

        Assert.Equal(
            _frameworks.SelectMany(f => new[] { $"lib/{f}/{name}.dll", $"lib/{f}/{name}.xml" }).Order(StringComparer.Ordinal),
            package.Entries.Select(e => e.FullName).Where(n => n.StartsWith("lib/", StringComparison.Ordinal))
                .Order(StringComparer.Ordinal));
        XElement[] farseer = [.. metadata.Descendants()
            .Where(e => e.Name.LocalName == "dependency" && e.Attribute("id")!.Value == "Farseer")];
        Assert.Equal(_frameworks.Length, farseer.Length);
        Assert.All(farseer, d => Assert.Equal($"[{library.Version}]", d.Attribute("version")!.Value));
    }

    [Fact]
    public void SavingPackage_HoldsItsAssemblyAlone_AndAsksForTheSameVersionOfTheOthers()
    {
        using ZipArchive package = ZipFile.OpenRead(library.PackageOf("Farseer.Serialization"));
        using Stream stream = package.GetEntry("Farseer.Serialization.nuspec")!.Open();
        XElement metadata = XDocument.Load(stream).Root!.Elements().Single();

        Assert.Equal(
            _frameworks.SelectMany(f => new[] { $"lib/{f}/Farseer.Serialization.dll", $"lib/{f}/Farseer.Serialization.xml" })
                .Order(StringComparer.Ordinal),
            package.Entries.Select(e => e.FullName).Where(n => n.StartsWith("lib/", StringComparison.Ordinal))
                .Order(StringComparer.Ordinal));
        XElement[] others = [.. metadata.Descendants()
            .Where(e => e.Name.LocalName == "dependency" && e.Attribute("id")!.Value.StartsWith("Farseer", StringComparison.Ordinal))];
        Assert.Equal(2 * _frameworks.Length, others.Length);
        Assert.All(others, d => Assert.Equal($"[{library.Version}]", d.Attribute("version")!.Value));
    }

    [Fact]
    public void Description_NamesLicenceReadmeIconAndOnlyPlatformPackages()
    {
        using ZipArchive package = ZipFile.OpenRead(library.Package);
        using Stream stream = package.GetEntry("Farseer.nuspec")!.Open();
        XElement metadata = XDocument.Load(stream).Root!.Elements().Single();

        Assert.Equal("Farseer", Value(metadata, "id"));
        Assert.Equal(library.Version, Value(metadata, "version"));
        Assert.Equal("MIT", Value(metadata, "license"));
        Assert.Equal("expression", Element(metadata, "license").Attribute("type")!.Value);
        Assert.Equal("README.md", Value(metadata, "readme"));
        Assert.Equal("icon.png", Value(metadata, "icon"));
        Assert.True(Value(metadata, "description").Length > 50);
        Assert.Equal(
            ["System.Memory", "System.Numerics.Vectors", "System.Runtime.CompilerServices.Unsafe"],
            metadata.Descendants().Where(e => e.Name.LocalName == "dependency").Select(e => e.Attribute("id")!.Value));
    }

    [Fact]
    public void Description_SaysWhereTheSourceIsAndWhatIsNew()
    {
        foreach ((string package, string id) in new[] { (library.Package, "Farseer"), (library.PackageOf(
            "Farseer.Box2DFlash"), "Farseer.Box2DFlash") })
        {
            XElement metadata = XDocument.Parse(Text(package, id + ".nuspec")).Root!.Elements().Single();

            // The address of the repository is that of the clone's remote; the commit is always known.
            XElement repository = Element(metadata, "repository");
            Assert.Equal("git", repository.Attribute("type")!.Value);
            Assert.Matches("^[0-9a-f]{40}$", repository.Attribute("commit")!.Value);
            Assert.Contains("CHANGELOG.md", Value(metadata, "releaseNotes"), StringComparison.Ordinal);
        }
    }

    [Fact]
    public void Readme_OfEachPackage_IsItsOwn_AndLinksToNothingThatIsNotThere()
    {
        string first = Text(library.Package, "README.md");
        string second = Text(library.PackageOf("Farseer.Box2DFlash"), "README.md");

        Assert.StartsWith("# Farseer\n", first, StringComparison.Ordinal);
        Assert.StartsWith("# Farseer.Box2DFlash\n", second, StringComparison.Ordinal);
        Assert.All(
            System.Text.RegularExpressions.Regex.Matches(first + second, @"\]\(([^)]+)\)").Select(m => m.Groups[1].Value),
            link => Assert.StartsWith("https://", link, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("netstandard2.0")]
    [InlineData("net8.0")]
    public void Documentation_OfPublicMembersAlone(string framework)
    {
        foreach ((string package, string name) in new[] { (library.Package, "Farseer"), (library.PackageOf(
            "Farseer.Box2DFlash"), "Farseer.Box2DFlash") })
        {
            List<string> members = [.. XDocument.Parse(Text(package, $"lib/{framework}/{name}.xml")).Descendants("member")
                .Select(m => m.Attribute("name")!.Value)];

            Assert.True(members.Count > 500, $"{name} documents {members.Count} members.");
            Assert.DoesNotContain(members, m => m.Contains(".Bridge.", StringComparison.Ordinal));
            Assert.DoesNotContain(members, m => System.Text.RegularExpressions.Regex.IsMatch(m, @"^F:.*\._[a-z]"));
        }

        Assert.Contains(
            "T:FarseerGames.FarseerPhysics.PhysicsSimulator",
            Text(library.Package, $"lib/{framework}/Farseer.xml"),
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("netstandard2.0", "Farseer")]
    [InlineData("netstandard2.0", "Farseer.Engine")]
    [InlineData("net8.0", "Farseer")]
    [InlineData("net8.0", "Farseer.Engine")]
    public void Assembly_IsReproducible_AndItsSymbolsFitIt(string framework, string name)
    {
        using ZipArchive package = ZipFile.OpenRead(library.Package);
        using ZipArchive symbols = ZipFile.OpenRead(library.Symbols);
        using PEReader assembly = new(Read(package, $"lib/{framework}/{name}.dll"));
        using MetadataReaderProvider pdb = MetadataReaderProvider.FromPortablePdbStream(Read(symbols, $"lib/{framework}/{name}.pdb"));
        List<DebugDirectoryEntry> entries = [.. assembly.ReadDebugDirectory()];

        Assert.Contains(entries, e => e.Type == DebugDirectoryEntryType.Reproducible);
        DebugDirectoryEntry view = entries.Single(e => e.Type == DebugDirectoryEntryType.CodeView);
        BlobContentId id = new(pdb.GetMetadataReader().DebugMetadataHeader!.Id);
        Assert.Equal(assembly.ReadCodeViewDebugDirectoryData(view).Guid, id.Guid);
        Assert.Equal(view.Stamp, id.Stamp);
    }

    [Theory]
    [InlineData("Farseer")]
    [InlineData("Farseer.Engine")]
    public void Net8Assembly_SaysThatItCanBeTrimmed(string name)
    {
        using ZipArchive package = ZipFile.OpenRead(library.Package);
        using PEReader assembly = new(Read(package, $"lib/net8.0/{name}.dll"));
        MetadataReader metadata = assembly.GetMetadataReader();

        // Each AssemblyMetadata attribute is a blob of two strings behind a prolog of two bytes.
        List<(string? Key, string? Value)> said = [];
        foreach (CustomAttribute attribute in metadata.GetAssemblyDefinition().GetCustomAttributes().Select(metadata.GetCustomAttribute))
        {
            if (attribute.Constructor.Kind == HandleKind.MemberReference
                && metadata.GetMemberReference(
                    (MemberReferenceHandle)attribute.Constructor).Parent is { Kind: HandleKind.TypeReference } parent
                && metadata.GetString(metadata.GetTypeReference((TypeReferenceHandle)parent).Name) == "AssemblyMetadataAttribute")
            {
                BlobReader blob = metadata.GetBlobReader(attribute.Value);
                blob.Offset = 2;
                said.Add((blob.ReadSerializedString(), blob.ReadSerializedString()));
            }
        }

        Assert.Contains(("IsTrimmable", "True"), said);
    }

    private static MemoryStream Read(ZipArchive archive, string entry)
    {
        MemoryStream copy = new();
        using Stream stream = archive.GetEntry(entry)!.Open();
        stream.CopyTo(copy);
        copy.Position = 0;
        return copy;
    }

    private static XElement Element(XElement metadata, string name) => metadata.Elements().Single(e => e.Name.LocalName == name);

    private static string Text(string package, string entry)
    {
        using ZipArchive archive = ZipFile.OpenRead(package);
        using StreamReader reader = new(archive.GetEntry(entry)!.Open());
        return reader.ReadToEnd().ReplaceLineEndings("\n");
    }

    private static string Value(XElement metadata, string name) => Element(metadata, name).Value;
}
