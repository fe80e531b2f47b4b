using Farseer.Engine.Contacts;
using Xunit;

namespace Farseer.Engine.Tests.Contacts;

public sealed unsafe class ContactBundleTests
{
    [Fact]
    public void Bytes_OfABundle_AreItsSize() => Assert.Equal(ContactBundle.Bytes, sizeof(ContactBundle));
}
