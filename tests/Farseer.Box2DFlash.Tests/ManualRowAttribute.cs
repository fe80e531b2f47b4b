using System;

namespace Farseer.Box2DFlash.Tests;

/// <summary>Names the rows of the manual that a test shows.</summary>
[AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
public sealed class ManualRowAttribute : Attribute
{
    public ManualRowAttribute(params string[] ids) => Ids = ids;

    /// <summary>Ids like "B024", or ranges like "B024-B030".</summary>
    public string[] Ids { get; }
}
