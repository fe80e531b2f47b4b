using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Xml.Linq;
using Microsoft.Build.Utilities;

/// <summary>
/// A step of the build: takes out of a documentation file what is said of types that are not public, and of private and internal members.
/// </summary>
public sealed class KeepPublicDocumentation : Task
{
    public string Assembly { get; set; }

    public string Documentation { get; set; }

    public string[] References { get; set; }

    public override bool Execute()
    {
        HashSet<string> hidden = Hidden();
        XDocument document = XDocument.Load(Documentation, LoadOptions.PreserveWhitespace);
        List<XElement> members = document.Descendants("member").Where(m => IsHidden((string)m.Attribute("name"), hidden)).ToList();
        foreach (XElement member in members)
        {
            if (member.PreviousNode is XText space)
            {
                space.Remove();
            }

            member.Remove();
        }

        if (members.Count > 0)
        {
            document.Save(Documentation, SaveOptions.DisableFormatting);
        }

        return true;
    }

    /// <summary>By its own name, or by that of the type that it is in: M:Space.Type.Name(Arguments) is in T:Space.Type.</summary>
    private static bool IsHidden(string name, HashSet<string> hidden)
    {
        int end = name.IndexOf('(');
        string path = end < 0 ? name.Substring(2) : name.Substring(2, end - 2);
        if (hidden.Contains(name[0] + ":" + path))
        {
            return true;
        }

        for (int dot = path.Length; dot > 0; dot = path.LastIndexOf('.', dot - 1))
        {
            if (hidden.Contains("T:" + path.Substring(0, dot)))
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>Types that nobody outside sees, and members of the others of which no overload is seen.</summary>
    private HashSet<string> Hidden()
    {
        const BindingFlags All =
            BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
        var hidden = new HashSet<string>(StringComparer.Ordinal);
        var shown = new HashSet<string>(StringComparer.Ordinal);
        using (var context = new MetadataLoadContext(new PathAssemblyResolver(References.Concat(new[] { Assembly }))))
        {
            foreach (Type type in context.LoadFromAssemblyPath(Assembly).GetTypes())
            {
                string name = type.FullName.Replace('+', '.');
                if (!type.IsVisible && !IsSeenByHeirs(type))
                {
                    hidden.Add("T:" + name);
                    continue;
                }

                foreach (FieldInfo field in type.GetFields(All))
                {
                    Sort("F:" + name + "." + field.Name, field.IsPublic || field.IsFamily || field.IsFamilyOrAssembly);
                }

                foreach (MethodBase method in type.GetMethods(All).Concat<MethodBase>(type.GetConstructors(All)))
                {
                    bool isSeen = method.IsPublic || method.IsFamily || method.IsFamilyOrAssembly;
                    Sort("M:" + name + "." + method.Name.Replace(".ctor", "#ctor"), isSeen);
                    if (method.Name.StartsWith("get_", StringComparison.Ordinal)
                        || method.Name.StartsWith("set_", StringComparison.Ordinal))
                    {
                        Sort("P:" + name + "." + method.Name.Substring(4), isSeen);
                    }
                }
            }
        }

        hidden.ExceptWith(shown);
        return hidden;

        void Sort(string member, bool isSeen) => (isSeen ? shown : hidden).Add(member);
    }

    private static bool IsSeenByHeirs(Type type) =>
        type.IsNested && (type.IsNestedFamily || type.IsNestedFamORAssem || type.IsNestedPublic)
        && (type.DeclaringType.IsVisible || IsSeenByHeirs(type.DeclaringType));
}
