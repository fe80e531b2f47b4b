#if !NETSTANDARD_ASSET
using System;
using Xunit;

namespace Farseer.Engine.Tests.Contacts;

/// <summary>A fact on processors with vectors of sixteen lanes.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class SixteenLanesFactAttribute : FactAttribute
{
    public SixteenLanesFactAttribute()
    {
        if (!Engine.Numerics.Sixteen.WideLanes.AreThere)
        {
            Skip = "This processor has no vectors of sixteen lanes.";
        }
    }
}
#endif
