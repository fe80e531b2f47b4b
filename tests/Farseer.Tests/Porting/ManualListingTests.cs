using System;
using System.Linq;
using System.Reflection;
using Xunit;

namespace Farseer.Tests.Porting;

/// <summary>Every listing of the manual compiles, or this assembly would not, and runs.</summary>
public sealed class ManualListingTests
{
    private static readonly MethodInfo[] _listings =
        typeof(ManualListings).GetMethods(BindingFlags.Public | BindingFlags.Static | BindingFlags.DeclaredOnly);

    public static TheoryData<string> Names => new(_listings.Select(m => m.Name));

    [Theory]
    [MemberData(nameof(Names))]
    public void Listing_AsTheManualHasIt_Runs(string name) =>
        Array.Find(_listings, m => m.Name == name)!.CreateDelegate<Action>()();

    [Fact]
    public void Listings_CountedInTheGuide_AreAllThere() =>
        Assert.Contains(
            $"{_listings.Length} of {_listings.Length} listings of the manual", TestData.Read("Porting.md"), StringComparison.Ordinal);
}
